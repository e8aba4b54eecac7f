// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/document/case_document.hpp"

#include "ionskin/case/schema/schema.hpp"

#include <utility>

namespace ionskin {

std::string to_string(ValueOrigin origin) {
  switch (origin) {
  case ValueOrigin::file:
    return "file";
  case ValueOrigin::set_edit:
    return "--set";
  case ValueOrigin::default_value:
    return "default";
  case ValueOrigin::preset:
    return "preset";
  }
  return "";
}

CaseDocument::CaseDocument(Case given, std::string name, std::vector<ValueRecord> values)
    : input(std::move(given)), file(std::move(name)), records(std::move(values)) {
  for (std::size_t i = 0; i < records.size(); ++i)
    index_.emplace(records[i].key, i);
}

const ValueRecord* CaseDocument::find(const std::string& key) const {
  const auto found = index_.find(key);
  return found == index_.end() ? nullptr : &records[found->second];
}

std::optional<NumberRecord> CaseDocument::number(const std::string& key) const {
  const ValueRecord* record = find(key);
  std::size_t index = 0;
  if (record == nullptr) {
    const auto entry = list_entry(key);
    if (!entry) {
      return {};
    }
    record = find(entry->list);
    index = entry->index;
  }
  if (record == nullptr || index >= record->value.numbers.size() ||
      (record->key == key && is_list(find_row(key_pattern(key))->type))) {
    return {};
  }
  return NumberRecord{record->value.numbers[index], record->value.dimension};
}

std::vector<Pointer> CaseDocument::point_at(const std::string& key, const std::string& note) const {
  const ValueRecord* record = find(key);
  if (record == nullptr || !record->place)
    return {};
  return {{*record->place, note}};
}

} // namespace ionskin
