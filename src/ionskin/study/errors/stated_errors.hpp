// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/readout/signals.hpp"

#include <map>
#include <optional>
#include <string>

namespace ionskin::study {

/// The stated errors of one run.
struct ErrorEstimate {
  std::map<std::string, double> relative; ///< sum of the parts over the value, by metric [1]
  /// Parts of the errors by metric and part, in the unit of the metric.
  std::map<std::string, std::map<std::string, double>> parts;
  std::map<std::string, std::string>
      not_converging; ///< reasons, by metric: finer meshes change it on
  std::map<std::string, std::string> not_estimated; ///< reasons, by metric
  /// Bands about the signals: the same columns, half a width per row [unit of the signal].
  readout::SignalTable signals, sampled;
  std::optional<readout::SignalTable> taxels, circuit, water;
};

} // namespace ionskin::study
