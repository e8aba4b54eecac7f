// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/document/unknown_key.hpp"

#include "ionskin/base/nearest_name.hpp"
#include "ionskin/case/schema/schema.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <vector>

namespace ionskin {
namespace {

std::string parent_of(const std::string& pattern) {
  const std::size_t dot = pattern.rfind('.');
  return dot == std::string::npos ? "" : pattern.substr(0, dot);
}

std::string last_of(const std::string& pattern) {
  return pattern.substr(pattern.rfind('.') + 1);
}

/// Names in the schema, cached because a text with many mistakes needs them for each.
struct SchemaNames {
  /// Names of keys and sub-tables of each table, by the name of the table, in the order of the
  /// schema.
  std::map<std::string, std::vector<std::string>> in_table;
  std::vector<std::string> last; ///< last name of the key of each row

  SchemaNames() {
    for (const SchemaRow& row : schema()) {
      last.push_back(last_of(row.key));
      for (std::size_t begin = 0; begin != std::string::npos;) {
        const std::string name = row.key.substr(begin, row.key.find_first_of(".[", begin) - begin);
        std::vector<std::string>& names = in_table[begin == 0 ? "" : row.key.substr(0, begin - 1)];
        if (std::find(names.begin(), names.end(), name) == names.end())
          names.push_back(name);
        const std::size_t dot = row.key.find('.', begin);
        begin = dot == std::string::npos ? dot : dot + 1;
      }
    }
  }
};

const SchemaNames& schema_names() {
  static const SchemaNames names;
  return names;
}

const std::vector<std::string>& names_in(const std::string& parent) {
  static const std::vector<std::string> none;
  const auto found = schema_names().in_table.find(parent);
  return found == schema_names().in_table.end() ? none : found->second;
}

// Finds a key in the table or below whose last name begins or ends the given name; else a key
// anywhere whose last name is similar.
std::string key_elsewhere(const std::string& name, const std::string& parent) {
  const std::vector<std::string>& last = schema_names().last;
  const std::string inside = parent + ".";
  for (std::size_t i = 0; i < last.size(); ++i)
    if ((name.ends_with("_" + last[i]) || name.starts_with(last[i] + "_")) &&
        schema()[i].key.starts_with(inside))
      return schema()[i].key;
  const std::string nearest = base::nearest_name(name, last);
  for (std::size_t i = 0; i < last.size(); ++i)
    if (!nearest.empty() && last[i] == nearest)
      return schema()[i].key;
  return "";
}

} // namespace

std::string meant_key(const std::string& key, const std::string& pattern) {
  const std::string table = parent_of(pattern), parent = parent_of(key), name = last_of(pattern);
  std::string meant = base::nearest_name(name, names_in(table));
  if (name.starts_with(meant + "_")) {
    // A name such as friction_law begins with one key of the table and ends with another, which is
    // meant.
    for (const std::string& sibling : names_in(table))
      if (name.ends_with("_" + sibling))
        meant = sibling;
  }
  if (meant.empty()) {
    const std::string elsewhere = key_elsewhere(name, table);
    if (elsewhere.empty() || parent_of(elsewhere) != table)
      return elsewhere;
    meant = last_of(elsewhere);
  }
  return parent.empty() ? meant : parent + "." + meant;
}

std::string list_of_siblings(const std::string& key, const std::string& pattern) {
  std::string list;
  for (const std::string& name : names_in(parent_of(pattern)))
    list += (list.empty() ? "" : ", ") + name;
  return parent_of(key).empty() ? "sections of a case: " + list
                                : fmt::format("keys of {}: {}", parent_of(key), list);
}

} // namespace ionskin
