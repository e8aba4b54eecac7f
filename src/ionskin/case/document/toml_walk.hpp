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

/// Reads a TOML tree by the schema: stores every known key in a draft of the case, records it, and
/// collects unknown keys and bad values as mistakes. Missing keys are left to `complete`.
class TomlWalk {
public:
  /// Function that converts a key to its name in messages.
  using Name = std::function<std::string(const std::string& key)>;

  /// Prepares a walk; all arguments taken by reference must outlive it.
  /// @param text text of the case, for positions in messages
  /// @param values the parsed `text`
  /// @param problems collects mistakes
  /// @param name converts keys that have another name in the text, as those of a slider in a list
  TomlWalk(
      const CaseText& text, const TomlText& values, Problems& problems,
      Name name = [](const std::string& key) { return key; })
      : name_of(std::move(name)), text_(text), values_(values), problems_(problems) {}

  /// Reads the whole tree into the members below.
  void visit() { visit_table(values_.root(), "", "", {}); }

  const Name name_of;               ///< converts a key to its name in messages
  CaseDraft draft;                  ///< the case as far as it is read
  std::vector<ValueRecord> records; ///< values read, in the order of the text
  /// Positions of the tables and lists of tables, by name: "skin", "skin.layers[0]".
  std::map<std::string, Place> tables;
  /// Number of entries of each list of tables, by name: "skin.layers".
  std::map<std::string, std::size_t> list_sizes;
  /// True for keys and sections that the text has, even with a bad value, and for those that an
  /// unknown key was probably meant to be.
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
