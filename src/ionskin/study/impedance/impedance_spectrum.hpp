// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/readout/signals.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace ionskin::study {

/// Range of frequencies of an impedance spectrum, both ends included.
struct FrequencyRange {
  double from = 0, to = 0; ///< [Hz]
  /// Points per decade, equally spaced in the logarithm; more where the range is no whole number of
  /// steps.
  int points_per_decade = 10;
};

/// Options of `run_impedance`.
struct ImpedanceOptions {
  FrequencyRange range;
  std::filesystem::path folder; ///< output folder
  bool overwrite = false;       ///< replaces the results of an earlier run
  std::string command;          ///< command line, recorded in manifest.json
};

/// Impedance spectrum and warnings of `run_impedance`.
struct ImpedanceOutcome {
  std::filesystem::path folder;
  std::vector<std::string> warnings;
  /// Table of `impedance_spectrum`.
  readout::SignalTable spectrum;
};

/// Frequencies of a range, ascending [Hz].
/// Throws UserError when the range is empty or not positive, or has too many points.
std::vector<double> frequencies(const FrequencyRange& range);

/// Computes the impedance between the electrodes at rest for small signals. Columns: frequency
/// [Hz]; impedance_real and impedance_imaginary [ohm]; area_impedance_real and
/// area_impedance_imaginary, the impedance times the area of the electrode [ohm m2]; magnitude
/// [ohm]; phase_angle [degree].
/// @param frequencies [Hz]
/// Throws SolverError when the resistance of the cell comes out not positive.
readout::SignalTable impedance_spectrum(const Case& input, const std::vector<double>& frequencies);

/// Computes an impedance spectrum and writes manifest.json, case.toml, impedance.csv and figures/
/// into the output folder.
/// Throws UserError before any work.
ImpedanceOutcome run_impedance(const Case& input, const ImpedanceOptions& options);

} // namespace ionskin::study
