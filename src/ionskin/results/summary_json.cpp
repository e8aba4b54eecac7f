// SPDX-License-Identifier: Apache-2.0
#include "ionskin/results/summary_json.hpp"

#include "ionskin/results/atomic_file.hpp"

#include <nlohmann/json.hpp>

namespace ionskin::results {

std::string summary_text(const Summary& summary) {
  nlohmann::ordered_json json;
  json["metrics"] = nlohmann::ordered_json::object();
  for (const readout::Metric& metric : summary.metrics) {
    json["metrics"][metric.name] = {{"value", metric.value}, {"unit", metric.unit}};
  }
  json["timing"] = summary.timing;
  json["warnings"] = summary.warnings;
  json["error_estimate"] = summary.error_estimate;
  return json.dump(2) + "\n";
}

void write_summary(const std::filesystem::path& path, const Summary& summary) {
  write_text_file(path, summary_text(summary));
}

} // namespace ionskin::results
