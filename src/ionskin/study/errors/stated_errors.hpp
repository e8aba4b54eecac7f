// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/readout/signals.hpp"

#include <map>
#include <optional>
#include <string>

namespace ionskin::study {

/// Reported numerical errors of the metrics and signals of one run. Made by `estimate_errors`.
struct ErrorEstimate {
  /// Sum of the parts of the error over the magnitude of the value, by metric [1].
  std::map<std::string, double> relative;
  /// Parts of the error by metric and name of the part (`error_parts`), in the unit of the metric.
  std::map<std::string, std::map<std::string, double>> parts;
  /// Reasons why a metric does not converge, by metric: finer meshes keep changing it, and its
  /// error is no bound.
  std::map<std::string, std::string> not_converging;
  /// Reasons why a metric has no error, by metric.
  std::map<std::string, std::string> not_estimated;
  /// Errors of the signals: tables with the same columns and rows, half the width of the error band
  /// about each value [unit of the signal]. Without columns, or empty, where not estimated.
  readout::SignalTable signals, sampled;
  std::optional<readout::SignalTable> taxels, circuit, water;
};

} // namespace ionskin::study
