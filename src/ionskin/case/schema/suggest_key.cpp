// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/schema/suggest_key.hpp"

#include "ionskin/base/nearest_name.hpp"
#include "ionskin/case/schema/schema.hpp"

#include <algorithm>
#include <map>
#include <vector>

namespace ionskin {
namespace {

/// Keys by the symbols that docs/model.md uses for them.
const std::map<std::string, std::string>& symbols() {
  static const std::map<std::string, std::string> table{
      {"k", "coupling.coefficient"},
      {"mu", "contact.friction"},
      {"D", "electrochemistry.diffusivity"},
      {"T", "electrochemistry.temperature"},
      {"c0", "electrochemistry.fixed_charge_concentration"},
      {"epsilon", "electrochemistry.permittivity"}};
  return table;
}

std::string last_name(const std::string& key) {
  return key.substr(key.rfind('.') + 1);
}

} // namespace

std::string suggest_key(const std::string& word) {
  if (const auto symbol = symbols().find(word); symbol != symbols().end()) {
    return symbol->second;
  }
  std::string name = word;
  std::ranges::replace(name, '-', '_');
  std::vector<std::string> keys, names;
  for (const SchemaRow& row : schema()) {
    if (row.key.find("[]") == std::string::npos && row.key.find("NAME") == std::string::npos) {
      keys.push_back(row.key);
      names.push_back(last_name(row.key));
    }
  }
  if (name.find('.') != std::string::npos) {
    return base::nearest_name(name, keys);
  }
  const std::string nearest = base::nearest_name(name, names);
  const auto found = std::ranges::find(names, nearest);
  return found == names.end() ? "" : keys[static_cast<std::size_t>(found - names.begin())];
}

} // namespace ionskin
