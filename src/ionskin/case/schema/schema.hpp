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

/// Type of the value of a key. A `quantity` is a number with a unit; a `_pair` is a list of two
/// entries, along x and along y.
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

/// True if values of this type are lists of numbers: pairs and lists.
bool is_list(ValueType type);

/// Condition under which a case must give a key. `optional`: never, as it has a default. `always`:
/// if `SchemaRow::applies`. `when_it_applies`: if `SchemaRow::applies` and the strain comes from
/// contact. `with_contact`, `with_strain_file`: if the strain comes from there. `one_of_several`:
/// the checks of the case require one of the keys with the same purpose. `where_known`: never, and
/// there is no default.
enum class Need {
  optional,
  always,
  with_contact,
  with_strain_file,
  when_it_applies,
  one_of_several,
  where_known
};

/// Allowed interval of a number, in SI units; each end is included or excluded.
struct Range {
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
  bool lower_included = true;
  bool upper_included = true;

  /// True if the value [SI] lies in the interval.
  bool contains(double value) const;
};

/// Describes a range in words for a message: "above 0 m", "at least 0 and below 0.5".
/// @param dimension of the number, for its SI unit
std::string describe(const Range& range, units::Dimension dimension);

/// One name that a key of type `choice` accepts. A name planned for later versions is refused with
/// a message of its own.
struct Choice {
  std::string name;
  bool in_this_version = true; ///< false for a name planned for later versions
};

/// A value of a key as read from a case, in SI units.
struct Value {
  std::string text;            ///< value of types `text` and `choice`; else empty
  std::vector<double> numbers; ///< of all other types: one for scalars, two for pairs [SI]
  units::Dimension dimension = units::Dimension::number; ///< of the numbers as written
};

/// A case while it is read. Materials are stored by name until `resolve_materials` copies them into
/// the layers.
struct CaseDraft {
  Case input;                                ///< the case as far as it is read
  std::map<std::string, Material> materials; ///< tables [materials.NAME] and presets, by name
};

/// Values of the wildcards in the key of a schema row, for one key of a case.
struct KeyIndex {
  std::size_t entry = 0; ///< index for `[]`: entry of a list of tables, from 0
  std::string material;  ///< name for `NAME`: the material; empty for other keys
};

/// Declaration of one key of a case file. The table of all rows, `schema`, drives reading,
/// checking, messages and documentation.
struct SchemaRow {
  /// Full name: "skin.length"; with wildcards "skin.layers[].name",
  /// "materials.NAME.poissons_ratio".
  std::string key{};
  ValueType type = ValueType::text;
  units::Dimension dimension = units::Dimension::number;
  std::optional<units::Dimension> other_dimension{}; ///< alternative dimension of a quantity
  Range range{};                                     ///< allowed numbers [SI]
  std::string range_reason{}; ///< reason for the limits of the range, for messages; may be empty
  Need need = Need::optional;
  /// Purpose that this key shares with its alternatives, if `need` is `one_of_several`; for
  /// messages.
  std::string purpose{};
  /// Function that returns true if the key has an effect in a case; empty for always.
  std::function<bool(const Case&)> applies{};
  /// True if a case may give the key even where `applies` is false.
  bool may_stand = false;
  std::string default_value{};   ///< TOML text, used if an optional key is missing; else empty
  std::vector<Choice> choices{}; ///< accepted names, for type `choice`
  /// False for a key of older versions, which is read but not used.
  bool has_effect = true;
  /// True if a missing key takes the value of the key of the same name of the core's material.
  bool of_material = false;
  /// True for a number of a material that may also be a list, with one entry for each entry of its
  /// key `humidity`.
  bool over_humidity = false;
  std::string help{};   ///< explanation in one or a few sentences
  std::string source{}; ///< source of the default value
  /// Stores a value that was read and checked in the draft of a case.
  std::function<void(CaseDraft&, const KeyIndex&, const Value&)> set{};
};

/// Table of all keys of a case, in the order of the reference page.
const std::vector<SchemaRow>& schema();

/// Finds the row of a key with wildcards, as `key_pattern` makes it; nullptr if there is none.
const SchemaRow* find_row(const std::string& pattern);

/// One entry of a list of numbers, as a key such as "slider.start[0]" names it.
struct ListEntry {
  std::string list;      ///< key of the list: "slider.start"
  std::size_t index = 0; ///< from 0; may be beyond the end of the list
};
/// Splits a key such as "slider.start[0]" into list and index. Returns empty for keys that do not
/// end in an index, and for entries of lists of tables such as "skin.layers[1]".
std::optional<ListEntry> list_entry(const std::string& key);

/// Converts a key of a case to the key of its schema row, with wildcards: "skin.layers[1].name" to
/// "skin.layers[].name". Keys in an entry of a list of sliders become those of a single slider:
/// "slider[1].motion.stroke" becomes "motion.stroke".
std::string key_pattern(const std::string& key);

} // namespace ionskin
