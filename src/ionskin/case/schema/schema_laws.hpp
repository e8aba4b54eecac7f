// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/schema/schema_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <string>
#include <vector>

namespace ionskin {

// Rows of the schema made of what the tables of laws declare.

template <class Law> std::vector<Choice> choices_of(std::span<const Law> table) {
  std::vector<Choice> choices;
  for (const Law& law : table)
    choices.push_back({std::string(law.name)});
  return choices;
}

/// One row per parameter of the laws of a section, "contact.NAME" or "coupling.NAME". Laws may
/// share a parameter: the first one that has it declares it.
template <class Law, class Section>
void add_law_parameters(SchemaRows& rows, const std::string& section, std::span<const Law> table,
                        Section Case::*member, Need need_without_default) {
  for (const Law& law : table)
    for (const laws::LawParameter& parameter : law.parameters) {
      const std::string name(parameter.name), key = section + "." + name;
      if (std::ranges::any_of(rows, [&](const SchemaRow& row) { return row.key == key; }))
        continue;
      std::string of;
      for (const Law& other : table)
        if (laws::has_parameter(table, other.name, name))
          of += fmt::format("{}\"{}\"", of.empty() ? "" : " or ", other.name);
      rows.push_back(
          {.key = key,
           .type = parameter.dimension == units::Dimension::number ? ValueType::number
                                                                   : ValueType::quantity,
           .dimension = parameter.dimension,
           .range = {parameter.lowest, parameter.highest, true, true},
           .need = parameter.default_value.empty() ? need_without_default : Need::optional,
           .applies =
               [member, table, name](const Case& input) {
                 return laws::has_parameter(table, (input.*member).law, name);
               },
           .default_value = std::string(parameter.default_value),
           .help = fmt::format("{} Of {}.law = {}.", parameter.help, section, of),
           .source = std::string(parameter.source),
           .set =
               [member, name](CaseDraft& draft, const KeyIndex&, const Value& value) {
                 (draft.input.*member).parameters[name] = value.numbers[0];
               }});
    }
}

} // namespace ionskin
