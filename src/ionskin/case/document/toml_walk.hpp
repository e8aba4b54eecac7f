// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/document/case_document.hpp"
#include "ionskin/case/schema/schema.hpp"
#include "ionskin/case/text/case_text.hpp"
#include "ionskin/case/text/toml_text.hpp"

#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace ionskin {

/// Walks a TOML tree along the schema: reads every known key into a draft, records it, and collects
/// unknown keys and bad values.
class TomlWalk {
public:
  /// Name of a key in messages.
  using Name = std::function<std::string(const std::string& key)>;

  /// @param values those of the text
  /// @param name of keys that stand elsewhere in the text, as those of a slider in a list
  TomlWalk(
      const CaseText& text, const TomlText& values, Problems& problems,
      Name name = [](const std::string& key) { return key; })
      : name_of(std::move(name)), text_(text), values_(values), problems_(problems) {}

  void visit() { visit_table(values_.root(), "", "", {}); }

  const Name name_of;
  CaseDraft draft;
  std::vector<ValueRecord> records;
  /// Places of the tables: "skin", "skin.layers[0]", "materials.nafion".
  std::map<std::string, Place> tables;
  /// Number of tables in each list of them: "skin.layers".
  std::map<std::string, std::size_t> list_sizes;
  /// Keys and sections that were there, even misspelt or with a bad value.
  std::map<std::string, bool> seen;

private:
  void visit_value(const toml::value& value, const std::string& key, const std::string& pattern,
                   const KeyIndex& index);
  void visit_table(const toml::value& value, const std::string& key, const std::string& pattern,
                   const KeyIndex& index);
  void visit_list(const toml::value& value, const std::string& key, const std::string& pattern);
  void read(const SchemaRow& row, const toml::value& value, const std::string& key,
            const KeyIndex& index);
  std::string name_beside(const std::string& key, const std::string& other) const;
  void report_unknown(const toml::value& value, const std::string& key, const std::string& pattern);
  Place place_of(const toml::value& value) const;

  const CaseText& text_;
  const TomlText& values_;
  Problems& problems_;
};

} // namespace ionskin
