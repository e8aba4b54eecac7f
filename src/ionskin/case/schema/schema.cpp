// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/schema/schema.hpp"

#include "ionskin/case/schema/schema_rows.hpp"
#include "ionskin/units/quantity.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <unordered_map>

namespace ionskin {

using units::Dimension;

bool Range::contains(double value) const {
  const bool above = lower_included ? value >= lower : value > lower;
  const bool below = upper_included ? value <= upper : value < upper;
  return above && below;
}

std::string describe(const Range& range, Dimension dimension) {
  const std::string lower = units::format_si(range.lower, dimension);
  const std::string upper = units::format_si(range.upper, dimension);
  const std::string from = fmt::format("{} {}", range.lower_included ? "at least" : "above", lower);
  const std::string to = fmt::format("{} {}", range.upper_included ? "at most" : "below", upper);
  if (std::isinf(range.lower))
    return std::isinf(range.upper) ? "any finite value" : to;
  return std::isinf(range.upper) ? from : from + " and " + to;
}

const std::vector<SchemaRow>& schema() {
  static const SchemaRows rows = [] {
    SchemaRows all;
    all.push_back({.key = "title",
                   .type = ValueType::text,
                   .default_value = "\"\"",
                   .help = "Title of the run, for the report.",
                   .set = [](CaseDraft& draft, const KeyIndex&, const Value& value) {
                     draft.input.title = value.text;
                   }});
    for (const auto add : {add_skin, add_layers, add_materials, add_ions_of_materials, add_slider,
                           add_motion, add_contact, add_electrochemistry, add_coupling, add_water,
                           add_strain, add_readout, add_run_control})
      add(all);
    return all;
  }();
  return rows;
}

const SchemaRow* find_row(const std::string& pattern) {
  static const auto index = [] {
    std::unordered_map<std::string, const SchemaRow*> by_key;
    for (const SchemaRow& row : schema())
      by_key.emplace(row.key, &row);
    return by_key;
  }();
  const auto found = index.find(pattern);
  return found == index.end() ? nullptr : found->second;
}

bool is_list(ValueType type) {
  return type == ValueType::number_pair || type == ValueType::quantity_pair ||
         type == ValueType::number_list || type == ValueType::quantity_list;
}

std::optional<ListEntry> list_entry(const std::string& key) {
  const std::size_t open = key.rfind('[');
  if (open == std::string::npos || key.size() < open + 3 || key.back() != ']') {
    return {};
  }
  const std::string digits = key.substr(open + 1, key.size() - open - 2);
  ListEntry entry{key.substr(0, open)};
  const auto [end, error] =
      std::from_chars(digits.data(), digits.data() + digits.size(), entry.index);
  const SchemaRow* row = find_row(key_pattern(entry.list));
  const bool whole = error == std::errc() && end == digits.data() + digits.size();
  return whole && row != nullptr && is_list(row->type) ? std::optional(entry) : std::nullopt;
}

std::string key_pattern(const std::string& key) {
  std::string pattern;
  bool in_index = false;
  for (const char letter : key) {
    in_index = in_index && letter != ']';
    if (!in_index)
      pattern += letter;
    in_index = in_index || letter == '[';
  }
  const std::string materials = "materials.";
  const std::size_t end = pattern.find('.', materials.size());
  if (pattern.starts_with(materials) && end != std::string::npos)
    pattern.replace(materials.size(), end - materials.size(), "NAME");
  const std::string listed = "slider[].";
  if (pattern.starts_with(listed)) {
    pattern.erase(0, listed.size());
    if (!pattern.starts_with("motion.") && !pattern.starts_with("contact."))
      pattern.insert(0, "slider.");
  }
  return pattern;
}

} // namespace ionskin
