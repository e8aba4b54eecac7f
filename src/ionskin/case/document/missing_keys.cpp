// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/document/missing_keys.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/case/document/read_value.hpp"
#include "ionskin/case/text/toml_text.hpp"

#include <fmt/format.h>

#include <map>
#include <set>

namespace ionskin {

namespace {

std::string section_of(const std::string& key) {
  const std::size_t dot = key.rfind('.');
  return dot == std::string::npos ? "" : key.substr(0, dot);
}

std::string example(const SchemaRow& row) {
  const std::string unit = units::dimension_info(row.dimension).examples.front();
  switch (row.type) {
  case ValueType::quantity:
    return fmt::format(
        "{} such as \"1 {}\"{}", units::dimension_info(row.dimension).name, unit,
        row.other_dimension ? " or " + units::dimension_info(*row.other_dimension).name : "");
  case ValueType::quantity_pair:
    return fmt::format("two values such as [\"3 {0}\", \"1.5 {0}\"]", unit);
  case ValueType::choice: {
    std::string list;
    for (const Choice& choice : row.choices)
      if (choice.in_this_version)
        list += fmt::format("{}\"{}\"", list.empty() ? "" : " or ", choice.name);
    return list;
  }
  case ValueType::text:
    return "a text in quotes";
  default:
    return "a number";
  }
}

class Completion {
public:
  Completion(TomlWalk& walk, const std::string& file, Problems& problems)
      : walk_(walk), file_(file), problems_(problems) {}

  void run() {
    for (const SchemaRow& row : schema()) {
      if (row.key.starts_with("materials."))
        continue;
      if (const std::size_t brackets = row.key.find("[]"); brackets != std::string::npos)
        for (std::size_t i = 0; i < walk_.list_sizes[row.key.substr(0, brackets)]; ++i)
          look_at(row, std::string(row.key).replace(brackets, 2, fmt::format("[{}]", i)), {i, ""});
      else
        look_at(row, row.key, {});
    }
    // Without its table there is no row to miss, yet a skin needs layers.
    if (walk_.draft.input.skin.layers.empty())
      problems_.add("the skin has no layers", pointers_to("skin"),
                    "add sections [[skin.layers]] from bottom to top: electrode, core, electrode");
  }

private:
  void look_at(const SchemaRow& row, const std::string& key, const KeyIndex& index) {
    if (walk_.seen[key])
      return;
    if (is_needed(row))
      report_missing(row, key);
    else if (!row.default_value.empty() && applies(row))
      set_default(row, key, index);
  }

  bool applies(const SchemaRow& row) const {
    return !row.applies || row.applies(walk_.draft.input);
  }

  bool is_needed(const SchemaRow& row) const {
    const StrainSourceKind source = walk_.draft.input.strain.kind;
    const bool contact = source == StrainSourceKind::contact;
    if (row.need == Need::when_it_applies)
      return contact && applies(row);
    return (row.need == Need::always && applies(row)) ||
           (row.need == Need::with_contact && contact) ||
           (row.need == Need::with_strain_file && source == StrainSourceKind::file);
  }

  void set_default(const SchemaRow& row, const std::string& key, const KeyIndex& index) {
    const Value& value = default_of(row);
    row.set(walk_.draft, index, value);
    walk_.records.push_back(
        {key, row.default_value, format_value(row, value), ValueOrigin::default_value, {}, value});
  }

  /// Parsed once, however many entries of a list take it.
  const Value& default_of(const SchemaRow& row) {
    const auto known = defaults_.find(&row);
    if (known != defaults_.end())
      return known->second;
    const TomlText text("value = " + row.default_value, "default of " + row.key);
    const auto result = read_value(row, row.key, text.root().as_table().at("value"));
    if (std::holds_alternative<BadValue>(result))
      throw InternalError("the default of " + row.key + " breaks its own row");
    return defaults_.emplace(&row, std::get<Value>(result)).first->second;
  }

  std::vector<Pointer> pointers_to(const std::string& table) const {
    const auto found = walk_.tables.find(table);
    return found == walk_.tables.end() ? std::vector<Pointer>{}
                                       : std::vector<Pointer>{{found->second, ""}};
  }

  void report_missing(const SchemaRow& row, const std::string& key) {
    const std::string section = section_of(key);
    const bool section_exists = walk_.tables.contains(section);
    if (!section_exists && !section.empty()) {
      const bool misspelt = walk_.seen[section];
      if (!misspelt && reported_sections_.insert(section).second)
        problems_.add(fmt::format("missing section [{}] in {}", section, file_), {},
                      fmt::format("add it with its keys: {}", needed_keys(section)));
      return;
    }
    problems_.add(fmt::format("missing key {} in {}", key, file_), pointers_to(section),
                  fmt::format("add it: {}", example(row)));
  }

  std::string needed_keys(const std::string& section) const {
    std::string list;
    std::map<std::string, std::string> alternatives; // by their purpose
    for (const SchemaRow& row : schema()) {
      if (section_of(row.key) != section)
        continue;
      const std::string name = row.key.substr(section.size() + 1);
      if (is_needed(row))
        list += (list.empty() ? "" : ", ") + name;
      else if (!row.purpose.empty() && applies(row))
        alternatives[row.purpose] += (alternatives[row.purpose].empty() ? "" : " or ") + name;
    }
    for (const auto& [purpose, names] : alternatives)
      list += fmt::format("; for the {} {}", purpose, names);
    return list;
  }

  TomlWalk& walk_;
  const std::string& file_;
  Problems& problems_;
  std::set<std::string> reported_sections_;
  std::map<const SchemaRow*, Value> defaults_;
};

} // namespace

void complete(TomlWalk& walk, const std::string& file, Problems& problems) {
  Completion(walk, file, problems).run();
}

} // namespace ionskin
