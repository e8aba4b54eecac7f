// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/text/case_text.hpp"
#include "ionskin/case/text/toml_text.hpp"

#include <optional>
#include <string>
#include <vector>

namespace ionskin {

/// One parsed argument `--set key=value`.
struct SetEdit {
  /// One part of a key between dots: a name, and the index of a list entry if one follows.
  struct Step {
    std::string name;
    std::optional<std::size_t> index; ///< from 0; empty without brackets
  };

  std::string argument;   ///< as the user wrote it
  std::vector<Step> path; ///< parts of the key
  std::string value;      ///< value as TOML

  /// Lists the names of the tables that contain the key, from the outside inwards, and last the
  /// key: "skin", "skin.layers", "skin.layers[1]", "skin.layers[1].name".
  std::vector<std::string> tables_and_key() const;
};

/// Parses one argument of --set.
/// @param argument "key=value", see `apply_set_edits`
/// Throws UserError that points into the argument when it is malformed.
SetEdit parse_set_edit(const std::string& argument);

/// An edit as a replacement in a text, with what it needs to be combined with other edits.
struct PlacedEdit {
  TextEdit text;
  /// Name of the key that the edit sets, or of the table that it creates. Two edits of the same
  /// text conflict if one sets this name, lies in it or contains it.
  std::string claim;
  bool on_top = false; ///< true if later edits at the same position go before this one
};

/// Finds the replacement that makes an edit in a text. A key that the text does not have is added
/// to its table, a missing table at the end of the text. The schema is not consulted: unknown keys
/// are refused later, when the case is read.
/// @param values the text, parsed
/// Throws UserError that points into the argument when the edit cannot be made.
PlacedEdit place_set_edit(const SetEdit& edit, const TomlText& values);

/// Throws UserError that points into an edit.
/// @param argument the edit as the user wrote it
/// @param value true to point at the value, false to point at the key
/// @param remedy advice to the user
[[noreturn]] void refuse_set_edit(const std::string& argument, const std::string& message,
                                  bool value, const std::string& remedy);

} // namespace ionskin
