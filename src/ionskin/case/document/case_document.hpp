// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/case/schema/schema.hpp"
#include "ionskin/case/text/place.hpp"

#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

namespace ionskin {

/// Origin of a value of a case: the case file, a `--set` edit, the default of its key, or a
/// material preset.
enum class ValueOrigin { file, set_edit, default_value, preset };

/// Name of an origin, for listings: "file", "--set", "default" or "preset".
std::string to_string(ValueOrigin origin);

/// One value of a case and its origin.
struct ValueRecord {
  std::string key;     ///< full name: "skin.layers[0].thickness"
  std::string written; ///< TOML text of the value, as written: "\"10 um\""
  std::string si;      ///< value as used, as a text with its SI unit: "1e-05 m"
  ValueOrigin origin = ValueOrigin::file;
  std::optional<Place> place; ///< position in the case, edit or preset; empty for defaults
  Value value{};              ///< value as used, in SI units
};

/// One number of a case and the physical dimension in which it was written.
struct NumberRecord {
  double value = 0; ///< in SI units
  units::Dimension dimension = units::Dimension::number;
};

/// A case together with the origins of its values. `read_case_document`
/// (case/reading/read_case.hpp) makes it.
struct CaseDocument {
  /// Takes the parts and indexes the records by key.
  /// @param file path of the case, for messages
  /// @param records one for each key that has a value, in the order of the schema
  CaseDocument(Case input, std::string file, std::vector<ValueRecord> records);

  Case input;
  std::string file;                 ///< path of the case, for messages
  std::vector<ValueRecord> records; ///< one for each key that has a value, in schema order

  /// Finds the record of a key such as "skin.layers[0].thickness"; nullptr if the key has no value.
  const ValueRecord* find(const std::string& key) const;
  /// Finds the number of a key with a single value, or of one entry of a list ("slider.start[0]");
  /// empty for texts, whole lists and keys without a value.
  std::optional<NumberRecord> number(const std::string& key) const;
  /// Finds the position of a key's value, for an error message: one pointer with the note, or empty
  /// if the value is a default or the key has none.
  std::vector<Pointer> point_at(const std::string& key, const std::string& note = "") const;

private:
  std::unordered_map<std::string, std::size_t> index_; ///< index into `records`, by key
};

} // namespace ionskin
