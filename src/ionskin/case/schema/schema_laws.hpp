// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/schema/schema_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ionskin {

// Rows of the schema made of what the tables of laws declare.

template <class Law> std::vector<Choice> choices_of(std::span<const Law> table) {
  std::vector<Choice> choices;
  for (const Law& law : table)
    choices.push_back({std::string(law.name)});
  return choices;
}

/// Phrases of the rows of a table, joined: "one thing, another, or a third".
template <class Row>
std::string alternatives(std::span<const Row> table, std::string_view Row::*phrase) {
  std::string list;
  for (const Row& row : table) {
    const char* before = &row == &table.back() ? ", or " : ", ";
    list += fmt::format("{}{}", list.empty() ? "" : before, row.*phrase);
  }
  return list;
}

inline ValueType type_of(const laws::LawParameter& parameter) {
  if (parameter.whole)
    return ValueType::integer;
  return parameter.dimension == units::Dimension::number ? ValueType::number : ValueType::quantity;
}

/// The names of the laws with a parameter: "\"coulomb\" or \"saturating\"".
template <class Law>
std::string laws_with_parameter(std::span<const Law> table, std::string_view parameter) {
  std::string names;
  for (const Law& law : table)
    if (laws::has_parameter(table, law.name, parameter))
      names += fmt::format("{}\"{}\"", names.empty() ? "" : " or ", law.name);
  return names;
}

/// The section of a case in which a law is chosen, and where its choice stands.
template <class Section> struct LawSection {
  std::string name, choice; ///< keys: "contact", "law"
  Section Case::*section = nullptr;
  std::string Section::*law = nullptr;
};
/// Clang deduces none for aggregates before version 17.
template <class Section>
LawSection(std::string, std::string, Section Case::*, std::string Section::*)
    -> LawSection<Section>;

/// One row per parameter of the laws of a section, such as "contact.NAME". Laws may share a
/// parameter: the first one that has it declares it.
/// @param idle_defaults whether parameters of laws that were not chosen have their defaults, too
template <class Law, class Section>
void add_law_parameters(SchemaRows& rows, const LawSection<Section>& of, std::span<const Law> table,
                        Need need_without_default, bool idle_defaults = false) {
  for (const Law& law : table)
    for (const laws::LawParameter& parameter : law.parameters) {
      const std::string name(parameter.name), key = of.name + "." + name;
      if (std::ranges::any_of(rows, [&](const SchemaRow& row) { return row.key == key; }))
        continue;
      std::function<bool(const Case&)> applies = [of, table, name](const Case& input) {
        return laws::has_parameter(table, (input.*of.section).*of.law, name);
      };
      if (idle_defaults && !parameter.default_value.empty())
        applies = nullptr;
      rows.push_back(
          {.key = key,
           .type = type_of(parameter),
           .dimension = parameter.dimension,
           .range = {parameter.lowest, parameter.highest, true, true},
           .need = parameter.default_value.empty() ? need_without_default : Need::optional,
           .applies = std::move(applies),
           .default_value = std::string(parameter.default_value),
           .help = fmt::format("{} Of {}.{} = {}.", parameter.help, of.name, of.choice,
                               laws_with_parameter(table, name)),
           .source = std::string(parameter.source),
           .set = [of, name](CaseDraft& draft, const KeyIndex&, const Value& value) {
             (draft.input.*of.section).parameters[name] = value.numbers[0];
           }});
    }
}

} // namespace ionskin
