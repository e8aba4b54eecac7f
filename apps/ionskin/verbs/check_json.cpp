// SPDX-License-Identifier: Apache-2.0
#include "verbs/check_json.hpp"

#include "command_line/threads.hpp"
#include "ionskin/planning/cost_estimate.hpp"
#include "verbs/explain.hpp"

#include "ionskin/case/schema/schema.hpp"
#include "ionskin/units/dimension.hpp"

#include <nlohmann/json.hpp>

namespace ionskin::apps {
namespace {

using Json = nlohmann::ordered_json;

Json value_json(const ValueRecord& record) {
  const bool pure = record.value.dimension == units::Dimension::number;
  return {{"key", record.key},
          {"written", record.written},
          {"si", record.si},
          {"numbers", record.value.numbers},
          {"unit", pure ? "" : units::dimension_info(record.value.dimension).si_unit},
          {"text", record.value.text},
          {"origin", to_string(record.origin)},
          {"line", record.place ? Json(record.place->line) : Json()}};
}

Json cost_json(const planning::CostEstimate& cost) {
  return {{"memory_bytes", cost.memory},
          {"output_bytes", cost.output},
          {"seconds", cost.seconds},
          {"threads", thread_count(0)},
          {"mechanics_unknowns", 3 * cost.contact_cells},
          {"contact_cells", cost.contact_cells},
          {"contact_steps", cost.contact_steps},
          {"ion_unknowns", cost.ion_unknowns},
          {"ion_steps", cost.ion_steps}};
}

} // namespace

std::string check_json(const CaseDocument& document, const std::string& warning,
                       const planning::CostEstimate& cost) {
  Json values = Json::array();
  for (const ValueRecord& record : document.records) {
    values.push_back(value_json(record));
  }
  Json applicable = Json::array();
  for (const SchemaRow& row : schema()) {
    if (row.has_effect && (!row.applies || row.applies(document.input))) {
      applicable.push_back(row.key);
    }
  }
  const Json all = {{"valid", true},
                    {"values", values},
                    {"applicable", applicable},
                    {"warning", warning},
                    {"explanation", explain(document, cost)},
                    {"cost", cost_json(cost)}};
  return all.dump(1, ' ', false, Json::error_handler_t::replace);
}

} // namespace ionskin::apps
