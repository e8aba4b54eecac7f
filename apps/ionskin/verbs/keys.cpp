// SPDX-License-Identifier: Apache-2.0
#include "verbs/keys.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/case/schema/schema.hpp"
#include "ionskin/case/schema/suggest_key.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <vector>

namespace ionskin::apps {
namespace {

using units::dimension_info;

std::string type_name(ValueType type) {
  switch (type) {
  case ValueType::text:
    return "text";
  case ValueType::choice:
    return "choice";
  case ValueType::integer:
    return "integer";
  case ValueType::number:
    return "number";
  case ValueType::number_pair:
    return "pair of numbers";
  case ValueType::quantity:
    return "quantity";
  case ValueType::quantity_pair:
    return "pair of quantities";
  case ValueType::number_list:
    return "list of numbers";
  case ValueType::quantity_list:
    return "list of quantities";
  }
  return "";
}

std::string need_name(const SchemaRow& row) {
  switch (row.need) {
  case Need::optional:
    return "optional";
  case Need::always:
    return row.applies ? "required where it applies" : "required";
  case Need::with_contact:
    return "required with strain.source = \"contact\"";
  case Need::with_strain_file:
    return "required with strain.source = \"file\"";
  case Need::when_it_applies:
    return "required where it applies";
  case Need::one_of_several:
    return "one of several keys for this is required";
  case Need::where_known:
    return "optional, no default";
  }
  return "";
}

bool has_dimension(const SchemaRow& row) {
  return row.dimension != units::Dimension::number;
}

std::string range_of(const SchemaRow& row) {
  const bool bounded = std::isfinite(row.range.lower) || std::isfinite(row.range.upper);
  return bounded ? describe(row.range, row.dimension) : "";
}

std::vector<std::string> choices_of(const SchemaRow& row) {
  std::vector<std::string> choices;
  for (const Choice& choice : row.choices) {
    if (choice.in_this_version) {
      choices.push_back(choice.name);
    }
  }
  return choices;
}

nlohmann::json json_of(const SchemaRow& row) {
  std::vector<std::string> kinds;
  if (has_dimension(row)) {
    kinds.push_back(dimension_info(row.dimension).name);
  }
  if (row.other_dimension) {
    kinds.push_back(dimension_info(*row.other_dimension).name);
  }
  return {{"key", row.key},
          {"type", type_name(row.type)},
          {"dimensions", kinds},
          {"si_unit", has_dimension(row) ? dimension_info(row.dimension).si_unit : ""},
          {"range", range_of(row)},
          {"range_reason", row.range_reason},
          {"need", need_name(row)},
          {"default", row.default_value},
          {"choices", choices_of(row)},
          {"help", row.help},
          {"source", row.source}};
}

std::string line_of(const SchemaRow& row, std::size_t width) {
  const std::string value = row.default_value.empty() ? need_name(row) : row.default_value;
  const auto choices = choices_of(row);
  const std::string allowed =
      choices.empty() ? range_of(row) : fmt::format("one of {}", fmt::join(choices, ", "));
  return fmt::format("{:<{}}  {}{}{}  [{}]\n", row.key, width, row.help,
                     allowed.empty() ? "" : "  ", allowed, value);
}

std::string keys_json(const std::vector<SchemaRow>& rows) {
  nlohmann::json all = nlohmann::json::array();
  for (const SchemaRow& row : rows) {
    all.push_back(json_of(row));
  }
  return all.dump(1);
}

} // namespace

std::string keys_json() {
  return keys_json(schema());
}

int keys(const KeysOptions& options) {
  std::vector<SchemaRow> rows;
  std::ranges::copy_if(schema(), std::back_inserter(rows), [&options](const SchemaRow& row) {
    return row.key.find(options.word) != std::string::npos;
  });
  if (rows.empty()) {
    const std::string nearest = suggest_key(options.word);
    throw UserError(fmt::format("no key of a case contains \"{}\"\n  = {}", options.word,
                                nearest.empty() ? "ionskin keys lists all"
                                                : fmt::format("did you mean {}?", nearest)));
  }
  if (options.json) {
    fmt::print("{}\n", keys_json(rows));
    return 0;
  }
  std::size_t width = 0;
  for (const SchemaRow& row : rows) {
    width = std::max(width, row.key.size());
  }
  for (const SchemaRow& row : rows) {
    fmt::print("{}", line_of(row, width));
  }
  return 0;
}

} // namespace ionskin::apps
