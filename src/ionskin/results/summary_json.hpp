// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/readout/metrics.hpp"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace ionskin::results {

/// Audit of a run: a metric that should be small, such as the violation of a conservation law, with
/// the thresholds of its verdict.
struct AuditEntry {
  std::string metric; ///< name of the metric
  /// Value of the metric, and the values above which the verdict is "warned" or "failed", in the
  /// unit of the metric.
  double value = 0, warn_above = 0, fail_above = 0;
  std::string verdict; ///< "passed", "warned" or "failed"
};

/// Description of the circuit between the electrodes of a run, for programs that draw it.
struct CircuitEntry {
  std::string name;  ///< name of the circuit in the case: "load"
  std::string words; ///< "resistor of 1000 ohm"
  /// Condition on the potential of the top electrode above the bottom one: "φ = U = R I".
  std::string top_potential;
};

/// Contents of summary.json: metrics of a run with their errors, timing, warnings and audits.
struct Summary {
  std::vector<readout::Metric> metrics;
  /// Wall time of the stages "mechanics", "strain", "electrochemistry" and "output", and "total"
  /// [s].
  std::map<std::string, double> timing;
  std::vector<std::string> warnings;
  std::map<std::string, double> error_estimate; ///< relative error estimate by metric [1]
  /// Contributions to the error estimate, by metric and source, in the unit of the metric; they add
  /// up to the error.
  std::map<std::string, std::map<std::string, double>> error_parts;
  /// Reasons, by metric, why finer meshes keep changing a metric instead of converging.
  std::map<std::string, std::string> not_converging;
  std::map<std::string, std::string> not_estimated; ///< reasons, by metric, for no error estimate
  std::vector<AuditEntry> audits;
  std::optional<CircuitEntry> circuit; ///< circuit of a run with Study 2; empty without it
};

/// Formats a summary as JSON text, with the metrics in the given order; a value that is not finite
/// becomes null.
std::string summary_text(const Summary& summary);
/// Writes `summary_text` to a file, atomically. Throws UserError when the file cannot be written.
void write_summary(const std::filesystem::path& path, const Summary& summary);

/// Reads a summary.json; audits and circuit are not read back. Throws UserError when the file is
/// missing or is not a summary.
Summary read_summary(const std::filesystem::path& path);
/// Reads the metrics of a summary.json, in the order of the file; a metric that was not finite is
/// NaN. Throws UserError when the file is missing or is not a summary.
std::vector<readout::Metric> read_metrics(const std::filesystem::path& path);

} // namespace ionskin::results
