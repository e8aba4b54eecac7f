// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/document/toml_walk.hpp"

#include "ionskin/base/text.hpp"
#include "ionskin/case/document/read_value.hpp"
#include "ionskin/case/document/unknown_key.hpp"
#include "ionskin/case/document/waypoint_file.hpp"
#include "ionskin/case/text/toml_limits.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace ionskin {

namespace {

const std::string material_wildcard = "NAME";

bool any_row_starts_with(const std::string& prefix) {
  return std::any_of(schema().begin(), schema().end(),
                     [&](const SchemaRow& row) { return row.key.starts_with(prefix); });
}

std::string joined(const std::string& parent, const std::string& name) {
  return parent.empty() ? name : parent + "." + name;
}

constexpr std::size_t most_layers = 50, most_taxels = 2000;
constexpr const char* layer_list = "skin.layers";
constexpr const char* waypoint_list = "motion.waypoints";

// Describes one entry of a list of tables, for messages.
std::string entry_name(const std::string& pattern) {
  if (pattern == waypoint_list)
    return "waypoint, in the order of time";
  return pattern == layer_list ? "layer, from bottom to top" : "taxel";
}

void resize_list(Case& input, const std::string& pattern, std::size_t size) {
  if (pattern == layer_list)
    input.skin.layers.resize(size);
  else if (pattern == waypoint_list)
    input.motion.waypoints.resize(size);
  else
    input.readout.taxels.resize(size);
}

} // namespace

Place TomlWalk::place_of(const toml::value& value) const {
  const TextSpan span = values_.span(value);
  return text_.place(span.begin, span.length);
}

void TomlWalk::visit_value(const toml::value& value, const std::string& key,
                           const std::string& pattern, const KeyIndex& index) {
  seen[key] = true;
  if (const SchemaRow* row = find_row(pattern))
    read(*row, value, key, index);
  else if (any_row_starts_with(pattern + "[].") &&
           !(value.is_table() && any_row_starts_with(pattern + ".")))
    visit_list(value, key, pattern);
  else if (any_row_starts_with(pattern + "."))
    visit_table(value, key, pattern, index);
  else
    report_unknown(value, key, pattern);
}

void TomlWalk::visit_table(const toml::value& value, const std::string& key,
                           const std::string& pattern, const KeyIndex& index) {
  if (!value.is_table()) {
    problems_.add(fmt::format("{} must be a table", name_of(key)), {{place_of(value), ""}},
                  fmt::format("write a section [{}] with its keys below", name_of(key)));
    return;
  }
  if (!key.empty())
    tables[key] = place_of(value);
  for (const auto& [name, child] : values_.children_in_order(value)) {
    if (name.size() > toml_limits::name_bytes || base::shown(name, name.size()) != name) {
      problems_.add(
          fmt::format("\"{}\" cannot be a name", base::shown(name)), {{place_of(*child), ""}},
          fmt::format("use at most {} bytes and no control characters", toml_limits::name_bytes));
      continue;
    }
    KeyIndex child_index = index;
    const bool is_material = pattern == "materials";
    if (is_material) {
      child_index.material = name;
      draft.materials[name].name = name;
    }
    visit_value(*child, joined(key, name), joined(pattern, is_material ? material_wildcard : name),
                child_index);
  }
}

void TomlWalk::visit_list(const toml::value& value, const std::string& key,
                          const std::string& pattern) {
  if (!value.is_array() || (!value.as_array().empty() && !value.as_array().front().is_table())) {
    problems_.add(fmt::format("{} must be a list of tables", name_of(key)), {{place_of(value), ""}},
                  fmt::format("write one section [[{}]] for each {}{}", name_of(key),
                              entry_name(pattern),
                              any_row_starts_with(pattern + ".")
                                  ? ", or a grid such as {rows = 2, columns = 4}"
                                  : ""));
    return;
  }
  tables[key] = place_of(value);
  const std::size_t most = pattern == layer_list      ? most_layers
                           : pattern == waypoint_list ? most_waypoints
                                                      : most_taxels;
  if (value.as_array().size() > most) {
    problems_.add(fmt::format("{} has {} entries", name_of(key), value.as_array().size()),
                  {{place_of(value), ""}}, fmt::format("it may have at most {}", most));
    return;
  }
  list_sizes[key] = value.as_array().size();
  resize_list(draft.input, pattern, value.as_array().size());
  for (std::size_t i = 0; i < value.as_array().size(); ++i)
    visit_table(value.as_array()[i], fmt::format("{}[{}]", key, i), pattern + "[]", {i, ""});
}

void TomlWalk::read(const SchemaRow& row, const toml::value& value, const std::string& key,
                    const KeyIndex& index) {
  const auto result = read_value(row, name_of(key), value);
  if (const BadValue* bad = std::get_if<BadValue>(&result)) {
    problems_.add(bad->message, {{place_of(*bad->where), ""}}, bad->remedy);
    return;
  }
  const Value& read = std::get<Value>(result);
  row.set(draft, index, read);
  const TextSpan span = values_.span(value);
  records.push_back({key, text_.text().substr(span.begin, span.length), format_value(row, read),
                     text_.is_edited(span.begin) ? ValueOrigin::set_edit : ValueOrigin::file,
                     place_of(value), read});
}

// Name of the key `other` in messages. A key of the same table as `key` gets the table's name in
// the text of the user.
std::string TomlWalk::name_beside(const std::string& key, const std::string& other) const {
  const std::size_t dot = key.rfind('.');
  const std::string table = key.substr(0, dot == std::string::npos ? 0 : dot + 1);
  const std::string shown = name_of(key);
  if (table.empty() || !other.starts_with(table))
    return name_of(other);
  return shown.substr(0, shown.size() - (key.size() - table.size())) + other.substr(table.size());
}

void TomlWalk::report_unknown(const toml::value& value, const std::string& key,
                              const std::string& pattern) {
  if (problems_.full()) {
    problems_.add("", {}, ""); // only counted: the nearest name would not be shown
    return;
  }
  const TextSpan span = values_.key_span(value);
  const std::vector<Pointer> where = {{text_.place(span.begin, span.length), ""}};
  const std::string meant = meant_key(key, pattern);
  seen[meant] = true; // so that it is not also reported as missing
  problems_.add(fmt::format("unknown {} {}", value.is_table() ? "section" : "key", name_of(key)),
                where,
                meant.empty() ? list_of_siblings(key, pattern)
                              : fmt::format("did you mean {}?", name_beside(key, meant)));
}

} // namespace ionskin
