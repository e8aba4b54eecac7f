// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/mechanics_error_estimate.hpp"

#include <algorithm>
#include <cmath>

namespace ionskin::study {

Case companion_case(const Case& input) {
  Case companion = input;
  companion.numerics.mesh_refinement *= 0.5;
  return companion;
}

std::map<std::string, double>
estimate_mechanics_errors(const std::vector<readout::Metric>& metrics,
                          const std::vector<readout::Metric>& companion_metrics) {
  std::map<std::string, double> errors;
  for (const readout::Metric& companion : companion_metrics) {
    const auto metric = std::ranges::find(metrics, companion.name, &readout::Metric::name);
    if (companion.name.ends_with("_residual") || companion.name.ends_with("_error") ||
        metric == metrics.end() || metric->value == 0.0) {
      continue;
    }
    errors[metric->name] = std::abs(companion.value - metric->value) / std::abs(metric->value);
  }
  return errors;
}

} // namespace ionskin::study
