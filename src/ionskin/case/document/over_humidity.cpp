// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/document/over_humidity.hpp"

#include "ionskin/base/value_at.hpp"
#include "ionskin/case/document/read_value.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <vector>

namespace ionskin {

namespace {

constexpr const char* humidity_key = "skin.humidity";

const ValueRecord* find_record(const TomlWalk& walk, const std::string& key) {
  const auto found = std::ranges::find(walk.records, key, &ValueRecord::key);
  return found == walk.records.end() ? nullptr : &*found;
}

std::vector<Pointer> place_of(const ValueRecord* record) {
  return record != nullptr && record->place ? std::vector<Pointer>{{*record->place, ""}}
                                            : std::vector<Pointer>{};
}

/// True if the humidities of a material ascend and skin.humidity lies within them; else reports a
/// mistake.
bool is_readable(const std::string& material, const std::vector<double>& humidities,
                 const TomlWalk& walk, Problems& problems) {
  const std::string key = fmt::format("materials.{}.humidity", material);
  const ValueRecord* record = find_record(walk, key);
  if (humidities.size() < 2 ||
      std::ranges::adjacent_find(humidities, std::greater_equal<>()) != humidities.end()) {
    problems.add(fmt::format("{} does not ascend over two entries or more", key), place_of(record),
                 "write ascending humidities, such as [0.5, 1]");
    return false;
  }
  const ValueRecord* given = find_record(walk, humidity_key);
  const auto seen = walk.seen.find(humidity_key);
  if (given == nullptr) {
    if (seen == walk.seen.end() || !seen->second) // a bad value is already reported
      problems.add(
          fmt::format("missing key {}: the material \"{}\" follows it", humidity_key, material),
          place_of(record),
          fmt::format("add it: a number from {:.6g} to {:.6g}", humidities.front(),
                      humidities.back()));
    return false;
  }
  const double humidity = given->value.numbers.front();
  if (humidity >= humidities.front() && humidity <= humidities.back())
    return true;
  problems.add(fmt::format("{} = {:.6g} is beyond the range of the material \"{}\"", humidity_key,
                           humidity, material),
               place_of(given),
               fmt::format("it must be from {:.6g} to {:.6g}, where its numbers have sources; or "
                           "give them for this humidity in [materials.{}] and remove {}",
                           humidities.front(), humidities.back(), material, humidity_key));
  return false;
}

/// True if a list has one entry for each humidity; else reports a mistake.
bool fits(const ValueRecord& record, const std::string& material, std::size_t humidities,
          Problems& problems) {
  if (record.value.numbers.size() == humidities)
    return true;
  const std::string scale = fmt::format("materials.{}.humidity", material);
  if (humidities == 0)
    problems.add(fmt::format("{} is a list, but {} is not given", record.key, scale),
                 place_of(&record), fmt::format("give {}, or one value", scale));
  else
    problems.add(fmt::format("{} has {} entries, and {} has {}", record.key,
                             record.value.numbers.size(), scale, humidities),
                 place_of(&record), "give one entry for each humidity, or one value");
  return false;
}

} // namespace

bool settle_humidity(const std::string& material, TomlWalk& walk, Problems& problems) {
  const std::string prefix = fmt::format("materials.{}.", material);
  const ValueRecord* scale = find_record(walk, prefix + "humidity");
  const std::vector<double> humidities =
      scale == nullptr ? std::vector<double>{} : scale->value.numbers;
  std::vector<ValueRecord*> lists;
  bool has_lists = false;
  for (ValueRecord& record : walk.records) {
    if (!record.key.starts_with(prefix) || record.value.numbers.size() < 2 ||
        !find_row(key_pattern(record.key))->over_humidity)
      continue;
    has_lists = true;
    if (fits(record, material, humidities.size(), problems))
      lists.push_back(&record);
  }
  if (lists.empty() || !is_readable(material, humidities, walk, problems))
    return has_lists;
  const double humidity = walk.draft.input.skin.humidity;
  for (ValueRecord* record : lists) {
    const SchemaRow& row = *find_row(key_pattern(record->key));
    record->value.numbers = {base::value_at(humidities, record->value.numbers, humidity)};
    record->si = format_value(row, record->value);
    row.set(walk.draft, {0, material}, record->value);
  }
  return true;
}

void refuse_humidity(const TomlWalk& walk, Problems& problems) {
  if (const ValueRecord* given = find_record(walk, humidity_key); given != nullptr)
    problems.add(fmt::format("{} is given, but no material of the skin follows it", humidity_key),
                 place_of(given),
                 "choose a material with lists over materials.NAME.humidity, such as "
                 "\"nafion_air\", or remove the key");
}

} // namespace ionskin
