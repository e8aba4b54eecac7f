// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/units/dimension.hpp"

#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace ionskin {

enum class ValueType {
  text,
  choice,
  integer,
  number,
  number_pair,
  quantity,
  quantity_pair,
  number_list,
  quantity_list
};

/// True for types whose value is several numbers.
bool is_list(ValueType type);

/// Condition under which a key must be given. `always`: where `SchemaRow::applies`.
/// `when_it_applies`: so with contact only. `one_of_several`: the checks of the case see to it that
/// one of the keys with the same purpose is there. `where_known`: never, and nothing stands in for
/// it.
enum class Need {
  optional,
  always,
  with_contact,
  with_strain_file,
  when_it_applies,
  one_of_several,
  where_known
};

/// Allowed interval of a number, in SI units; each end belongs to it or not.
struct Range {
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
  bool lower_included = true;
  bool upper_included = true;

  bool contains(double value) const;
};

/// The range in words: "> 0 m", "from 0 to 5", "at least 0 and below 0.5".
std::string describe(const Range& range, units::Dimension dimension);

/// One name that a key of type `choice` takes. Names of later versions get an answer of their own.
struct Choice {
  std::string name;
  bool in_this_version = true;
};

/// A value as read, in SI units.
struct Value {
  std::string text;                                      ///< of `text` and `choice`
  std::vector<double> numbers;                           ///< one for scalars, two for pairs
  units::Dimension dimension = units::Dimension::number; ///< dimension of the numbers as written
};

/// Destination of the values of a case while it is read: materials are known by name until layers
/// take them.
struct CaseDraft {
  Case input;
  std::map<std::string, Material> materials;
};

/// Meaning of the wildcards of a row's key.
struct KeyIndex {
  std::size_t entry = 0; ///< of a list of tables, from 0
  std::string material;
};

/// One key of a case file. The table of all rows drives reading, checking, messages and
/// documentation.
struct SchemaRow {
  std::string
      key{}; ///< "skin.length"; wildcards "skin.layers[].name", "materials.NAME.poissons_ratio"
  ValueType type = ValueType::text;
  units::Dimension dimension = units::Dimension::number;
  std::optional<units::Dimension> other_dimension{}; ///< a quantity may have this one instead
  Range range{};
  std::string range_reason{}; ///< reason for the ends of the range, when it is not plain
  Need need = Need::optional;
  /// Purpose of the keys of `one_of_several` that stand in for one another, for messages.
  std::string purpose{};
  /// True where the key has a meaning in a case; empty for always.
  std::function<bool(const Case&)> applies{};
  /// Has a meaning where `applies` is false, too, though it is not asked for there.
  bool may_stand = false;
  std::string default_value{};   ///< TOML; used when an optional key is missing
  std::vector<Choice> choices{}; ///< of type `choice`
  /// False for a key of older versions, which is read and comes to nothing.
  bool has_effect = true;
  /// Comes from the key of the same name of the core's material where the case is silent.
  bool of_material = false;
  /// A number of a material that may also be a list, one entry for each of its humidities.
  bool over_humidity = false;
  std::string help{};   ///< one sentence
  std::string source{}; ///< source of the default
  std::function<void(CaseDraft&, const KeyIndex&, const Value&)> set{};
};

/// All keys in the order of the reference page.
const std::vector<SchemaRow>& schema();

/// The row of a key pattern, or nullptr.
const SchemaRow* find_row(const std::string& pattern);

/// A list and the place in it that a key such as "slider.start[0]" names.
struct ListEntry {
  std::string list;
  std::size_t index = 0;
};
/// Empty for keys that do not end in an index, and for those of tables such as "skin.layers[1]".
std::optional<ListEntry> list_entry(const std::string& key);

/// The pattern that a key of a case follows: "skin.layers[].name" of "skin.layers[1].name". Keys in
/// an entry of a list of sliders follow those of the only slider: "motion.stroke" of
/// "slider[1].motion.stroke".
std::string key_pattern(const std::string& key);

} // namespace ionskin
