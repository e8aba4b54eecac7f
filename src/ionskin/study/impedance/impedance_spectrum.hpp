// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/readout/signals.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace ionskin::study {

/// Range from the lowest to the highest frequency, both included.
struct FrequencyRange {
  double from = 0, to = 0;    ///< [Hz]
  int points_per_decade = 10; ///< equally spaced in the logarithm; more where that does not fit
};

/// Frequencies of a spectrum and where it is written.
struct ImpedanceOptions {
  FrequencyRange range;
  std::filesystem::path folder; ///< of the results
  bool overwrite = false;
  std::string command; ///< for the manifest
};

/// A spectrum and its warnings.
struct ImpedanceOutcome {
  std::filesystem::path folder;
  std::vector<std::string> warnings;
  readout::SignalTable spectrum;
};

/// Throws UserError when the range is empty or not positive.
std::vector<double> frequencies(const FrequencyRange& range);

/// Impedance between the electrodes at rest: columns frequency, impedance_real and
/// impedance_imaginary, both times the area of the electrode, magnitude and phase_angle.
readout::SignalTable impedance_spectrum(const Case& input, const std::vector<double>& frequencies);

/// Writes manifest.json, case.toml, impedance.csv and figures/. Throws UserError before any work.
ImpedanceOutcome run_impedance(const Case& input, const ImpedanceOptions& options);

} // namespace ionskin::study
