// SPDX-License-Identifier: Apache-2.0
#include "ionskin/results/summary_json.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/base/files/atomic_file.hpp"
#include "ionskin/base/files/read_json.hpp"
#include "ionskin/base/text.hpp"

#include <fmt/format.h>

#include <limits>
#include <optional>
#include <string_view>

namespace ionskin::results {
namespace {

/// True if a text can be the name of a table column and of a dataset: printable, not only dots, and
/// without any of the `forbidden` characters.
bool is_name(const std::string& text, std::string_view forbidden) {
  return text.find_first_not_of('.') != std::string::npos &&
         text.find_first_of(forbidden) == std::string::npos &&
         base::shown(text, text.size()) == text;
}

/// Converts JSON to a summary. Nothing (`nullopt`) when a metric has an invalid name or unit.
/// Throws exceptions of the JSON library when a value is missing or has another type.
std::optional<Summary> summary_of(const base::Json& json) {
  Summary summary;
  for (const auto& [name, entry] : json.at("metrics").get_ref<const base::Json::object_t&>()) {
    const auto& value = entry.at("value");
    const auto unit = entry.at("unit").get<std::string>();
    if (!is_name(name, "/,\"[]") || !is_name(unit, ",\"[]")) {
      return std::nullopt;
    }
    summary.metrics.push_back(
        {name, value.is_null() ? std::numeric_limits<double>::quiet_NaN() : value.get<double>(),
         unit});
  }
  summary.timing = json.value("timing", summary.timing);
  summary.warnings = json.value("warnings", summary.warnings);
  summary.error_estimate = json.value("error_estimate", summary.error_estimate);
  summary.error_parts = json.value("error_parts", summary.error_parts);
  summary.not_converging = json.value("not_converging", summary.not_converging);
  summary.not_estimated = json.value("not_estimated", summary.not_estimated);
  return summary;
}

} // namespace

std::string summary_text(const Summary& summary) {
  base::Json json;
  json["metrics"] = base::Json::object();
  for (const readout::Metric& metric : summary.metrics) {
    json["metrics"][metric.name] = {{"value", metric.value}, {"unit", metric.unit}};
  }
  json["timing"] = summary.timing;
  json["warnings"] = summary.warnings;
  json["error_estimate"] = summary.error_estimate;
  json["error_parts"] = summary.error_parts;
  json["not_converging"] = summary.not_converging;
  json["not_estimated"] = summary.not_estimated;
  json["audits"] = base::Json::object();
  for (const AuditEntry& audit : summary.audits) {
    json["audits"][audit.metric] = {{"value", audit.value},
                                    {"warn_above", audit.warn_above},
                                    {"fail_above", audit.fail_above},
                                    {"verdict", audit.verdict}};
  }
  if (summary.circuit) {
    json["circuit"] = {{"name", summary.circuit->name},
                       {"words", summary.circuit->words},
                       {"top_potential", summary.circuit->top_potential}};
  }
  // File names in warnings need not be UTF-8, but JSON must be.
  return json.dump(2, ' ', false, base::Json::error_handler_t::replace) + "\n";
}

void write_summary(const std::filesystem::path& path, const Summary& summary) {
  base::write_text_file(path, summary_text(summary));
}

Summary read_summary(const std::filesystem::path& path) {
  const UserError damaged(
      fmt::format("{} is missing or no summary of a run\n  = run the case again "
                  "with --overwrite",
                  path.string()));
  try {
    const auto json = base::read_json(path, "summary");
    const auto summary = json ? summary_of(*json) : std::nullopt;
    if (!summary) {
      throw damaged;
    }
    return *summary;
  } catch (const base::Json::exception&) {
    throw damaged;
  } catch (const UserError&) {
    throw damaged;
  }
}

std::vector<readout::Metric> read_metrics(const std::filesystem::path& path) {
  return read_summary(path).metrics;
}

} // namespace ionskin::results
