// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/document/missing_keys.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/case/document/read_value.hpp"
#include "ionskin/case/text/toml_text.hpp"

#include <fmt/format.h>

#include <map>
#include <set>
#include <utility>
#include <vector>

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
  Completion(TomlWalk& walk, const std::string& file, const std::optional<EditedChoices>& choices,
             Problems& problems)
      : walk_(walk), file_(file), choices_(choices), problems_(problems) {}

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
    report_asked_for();
    // A skin needs layers, but no key of a layer is missing if there is no layer at all.
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

  bool is_needed(const SchemaRow& row) const { return is_needed(row, walk_.draft.input); }

  static bool is_needed(const SchemaRow& row, const Case& input) {
    const bool applies = !row.applies || row.applies(input);
    const StrainSourceKind source = input.strain.kind;
    const bool contact = source == StrainSourceKind::contact;
    if (row.need == Need::when_it_applies)
      return contact && applies;
    return (row.need == Need::always && applies) || (row.need == Need::with_contact && contact) ||
           (row.need == Need::with_strain_file && source == StrainSourceKind::file);
  }

  void set_default(const SchemaRow& row, const std::string& key, const KeyIndex& index) {
    const Value& value = default_of(row);
    row.set(walk_.draft, index, value);
    walk_.records.push_back(
        {key, row.default_value, format_value(row, value), ValueOrigin::default_value, {}, value});
  }

  /// The default of a row, parsed at the first call and cached: many entries of a list may need it.
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
        problems_.add(fmt::format("missing section [{}] in {}", walk_.name_of(section), file_), {},
                      fmt::format("add it with its keys: {}", needed_keys(section)));
      return;
    }
    if (choices_ && !is_needed(row, choices_->before))
      asked_for_.emplace_back(key, &row);
    else
      report_key(row, key);
  }

  void report_key(const SchemaRow& row, const std::string& key) {
    problems_.add(fmt::format("missing key {} in {}", walk_.name_of(key), file_),
                  pointers_to(section_of(key)), fmt::format("add it: {}", example(row)));
  }

  /// Reports the keys that are missing because of edited choices as one mistake, with one remedy.
  void report_asked_for() {
    if (asked_for_.size() == 1)
      report_key(*asked_for_.front().second, asked_for_.front().first);
    if (asked_for_.size() < 2)
      return;
    std::string keys, examples;
    for (const auto& [key, row] : asked_for_) {
      keys += (keys.empty() ? "" : ", ") + key;
      examples += fmt::format("{}{}, {}", examples.empty() ? "" : "; ", key, example(*row));
    }
    problems_.add(
        fmt::format("{} needs keys that {} does not have: {}", choices_->words, file_, keys),
        choices_->places, fmt::format("set them, too, by --set KEY=VALUE: {}", examples));
  }

  std::string needed_keys(const std::string& section) const {
    std::string list;
    std::map<std::string, std::string> alternatives; // names of keys, by purpose
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
  const std::optional<EditedChoices>& choices_;
  Problems& problems_;
  std::vector<std::pair<std::string, const SchemaRow*>>
      asked_for_; ///< missing because of edited choices
  std::set<std::string> reported_sections_;
  std::map<const SchemaRow*, Value> defaults_;
};

} // namespace

void complete(TomlWalk& walk, const std::string& file, const std::optional<EditedChoices>& choices,
              Problems& problems) {
  Completion(walk, file, choices, problems).run();
}

} // namespace ionskin
