// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/readout/metrics.hpp"

#include <string>
#include <vector>

namespace ionskin::study {

/// Root mean square noise of one reading, which is the mean over `readout.sample_interval`: of the
/// current between electrodes at one potential [A], otherwise of the voltage [V];
/// docs/model.md (61). Made by `sample_noise`.
struct SampleNoise {
  double thermal = 0; ///< thermal noise of the cell, and of the resistor beside it
  /// Noise of the amplifier, from its voltage and current noise at the impedance of the cell.
  double amplifier = 0;
  double quantisation = 0; ///< rounding of the analogue-to-digital converter

  /// Root of the sum of squares of all three.
  double total() const;
};

/// Noise of one reading of the instrument of a case, by source.
/// @param peak of the sampled signal [A] or [V], from which the range of the converter follows; 0
/// for a converter in any range
/// @param record length of the run [s]
SampleNoise sample_noise(const Case& input, double peak, double record);

/// Noise of the current that follows from one reading [A]: the noise itself where a current is
/// read; that of a voltage times the admittance of the resistor and capacitor of the circuit, with
/// the change of the capacitor's charge within an interval; 0 if nothing joins the electrodes.
double current_noise(const Case& input, const SampleNoise& noise);

/// Metrics of the noise: its parts, its total, and the signal-to-noise ratio, the peak over the
/// total.
/// @param peak of the readings, means over the readout interval [unit]
/// @param unit of peak and noise: "A" or "V"
std::vector<readout::Metric> noise_metrics(const SampleNoise& noise, double peak,
                                           const std::string& unit);

} // namespace ionskin::study
