// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/readout/metrics.hpp"

#include <string>
#include <vector>

namespace ionskin::study {

/// Rms noise of the mean over `readout.sample_interval`, docs/model.md (61): of the current between
/// electrodes at one potential [A], else of the voltage [V].
struct SampleNoise {
  double thermal = 0; ///< of the cell, and of the resistor beside it
  double amplifier =
      0; ///< noise of the amplifier's own voltage and current at the cell's impedance
  double quantisation = 0; ///< of the converter

  double total() const;
};

/// Noise of one reading of the instrument of a case, by its sources.
/// @param peak of the sampled signal [A] or [V]; 0 for a converter in any range
/// @param record length of the run [s]
SampleNoise sample_noise(const Case& input, double peak, double record);

/// The parts of it, the whole, and the peak over the whole.
/// @param unit of the peak: A or V
std::vector<readout::Metric> noise_metrics(const SampleNoise& noise, double peak,
                                           const std::string& unit);

} // namespace ionskin::study
