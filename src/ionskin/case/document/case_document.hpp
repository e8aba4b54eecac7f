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

/// Origin of a value of a case.
enum class ValueOrigin { file, set_edit, default_value, preset };

/// "file", "--set", "default", "preset".
std::string to_string(ValueOrigin origin);

/// One value of a case and where it came from.
struct ValueRecord {
  std::string key;     ///< "skin.layers[0].thickness"
  std::string written; ///< as written: "\"10 um\""
  std::string si;      ///< as used: "1e-05 m"
  ValueOrigin origin = ValueOrigin::file;
  std::optional<Place> place; ///< empty for defaults
  Value value{};              ///< as used
};

/// One number of a case and the dimension that it was written in.
struct NumberRecord {
  double value = 0; ///< SI
  units::Dimension dimension = units::Dimension::number;
};

/// A case together with the origin of its values.
struct CaseDocument {
  /// @param records those of the case, each key once, in the order of the schema
  CaseDocument(Case input, std::string file, std::vector<ValueRecord> records);

  Case input;
  std::string file;
  std::vector<ValueRecord> records;

  /// The record of a key, or nullptr.
  const ValueRecord* find(const std::string& key) const;
  /// The number of a key with one value, or of an entry of a list ("slider.start[0]"); empty for
  /// texts, whole lists and unknown keys.
  std::optional<NumberRecord> number(const std::string& key) const;
  /// Where the key stands, with a note; empty when its value is a default.
  std::vector<Pointer> point_at(const std::string& key, const std::string& note = "") const;

private:
  std::unordered_map<std::string, std::size_t> index_; ///< of records, by key
};

} // namespace ionskin
