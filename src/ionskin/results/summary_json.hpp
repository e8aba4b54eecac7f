// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/readout/metrics.hpp"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace ionskin::results {

/// One of the quantities by which a run is judged.
struct AuditEntry {
  std::string metric;
  double value = 0, warn_above = 0, fail_above = 0;
  std::string verdict; ///< "passed", "warned" or "failed"
};

/// The circuit of the run, for those who draw it.
struct CircuitEntry {
  std::string name;          ///< "load"
  std::string words;         ///< "resistor of 1000 ohm"
  std::string top_potential; ///< of the top electrode above the bottom one: "φ = U = R I"
};

/// Contents of summary.json: metrics with errors, timing, warnings, audits.
struct Summary {
  std::vector<readout::Metric> metrics;
  std::map<std::string, double> timing; ///< mechanics, strain, electrochemistry, output, total [s]
  std::vector<std::string> warnings;
  std::map<std::string, double> error_estimate; ///< relative, by metric [1]
  /// Parts of the errors by metric and part, in the unit of the metric; they add up to the error.
  std::map<std::string, std::map<std::string, double>> error_parts;
  std::map<std::string, std::string> not_converging; ///< reasons, by metric
  std::map<std::string, std::string> not_estimated;  ///< reasons, by metric
  std::vector<AuditEntry> audits;
  std::optional<CircuitEntry> circuit; ///< of a run with ions
};

/// The JSON text, metrics in the given order; a value that is not finite becomes null.
std::string summary_text(const Summary& summary);
/// Writes the file atomically. Throws UserError when it cannot.
void write_summary(const std::filesystem::path& path, const Summary& summary);

/// Reads the file. Throws UserError when it is missing or no summary.
Summary read_summary(const std::filesystem::path& path);
/// The metrics of a summary.json in the order of the file, those that are not finite as
/// NaN. Throws UserError when the file is missing or no summary.
std::vector<readout::Metric> read_metrics(const std::filesystem::path& path);

} // namespace ionskin::results
