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

// Rows of the schema that are made from the declarations in the tables of laws.

/// Names of all laws of a table, as choices of a key.
template <class Law> std::vector<Choice> choices_of(std::span<const Law> table) {
  std::vector<Choice> choices;
  for (const Law& law : table)
    choices.push_back({std::string(law.name)});
  return choices;
}

/// Joins one phrase of every row of a table for a help text: "one thing, another, or a third".
/// @param phrase member of the row that holds the phrase
template <class Row>
std::string alternatives(std::span<const Row> table, std::string_view Row::*phrase) {
  std::string list;
  for (const Row& row : table) {
    const char* before = &row == &table.back() ? ", or " : ", ";
    list += fmt::format("{}{}", list.empty() ? "" : before, row.*phrase);
  }
  return list;
}

/// Type of the key that is made of a law's parameter.
inline ValueType type_of(const laws::LawParameter& parameter) {
  if (parameter.whole)
    return ValueType::integer;
  return parameter.dimension == units::Dimension::number ? ValueType::number : ValueType::quantity;
}

/// Joins the names of the laws that have a parameter, for a message: "\"coulomb\" or
/// \"saturating\"". Empty if no law has it.
template <class Law>
std::string laws_with_parameter(std::span<const Law> table, std::string_view parameter) {
  std::string names;
  for (const Law& law : table)
    if (laws::has_parameter(table, law.name, parameter))
      names += fmt::format("{}\"{}\"", names.empty() ? "" : " or ", law.name);
  return names;
}

/// Section of a case in which a law is chosen: its names in the file, and its members in the
/// structs.
template <class Section> struct LawSection {
  std::string name, choice;            ///< name of the section, and of its key: "contact", "law"
  Section Case::*section = nullptr;    ///< struct of the section in `Case`
  std::string Section::*law = nullptr; ///< member that holds the name of the chosen law
};
/// Deduction guide, which Clang before version 17 needs for aggregates.
template <class Section>
LawSection(std::string, std::string, Section Case::*, std::string Section::*)
    -> LawSection<Section>;

/// Adds a row to the schema for each parameter of the laws of a section, such as "contact.NAME".
/// Laws may share a parameter; the declaration of the first law that has it counts.
/// @param rows the schema so far, to which rows are appended
/// @param of the section, whose struct has a member `parameters`
/// @param table all laws of the section
/// @param need_without_default need of parameters that have no default
/// @param idle_defaults true if parameters of laws that are not chosen get their defaults, too
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
