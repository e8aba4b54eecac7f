// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/text/case_text.hpp"
#include "ionskin/case/text/toml_text.hpp"

#include <optional>
#include <string>
#include <vector>

namespace ionskin {

/// One `--set key=value`, read.
struct SetEdit {
  /// A name, with the index into an array where one follows.
  struct Step {
    std::string name;
    std::optional<std::size_t> index;
  };

  std::string argument; ///< as the user wrote it
  std::vector<Step> path;
  std::string value; ///< as TOML

  /// Names of the tables in which the key lies, and of the key: "skin", "skin.layers",
  /// "skin.layers[1]", "skin.layers[1].name".
  std::vector<std::string> tables_and_key() const;
};

/// Reads one argument of --set.
/// @param argument see `apply_set_edits`
/// Throws UserError pointing into the argument.
SetEdit parse_set_edit(const std::string& argument);

/// An edit and where it goes in a text.
struct PlacedEdit {
  TextEdit text;
  /// The key that it sets, or the table or part of a key that it makes: what another edit placed in
  /// the same text must neither set, nor lie in, nor hold.
  std::string claim;
  bool on_top = false; ///< true if later edits at the same place stand before it
};

/// A key that is not there yet is added to its table, a table that is not there yet to the end.
/// Throws UserError pointing into the argument. Whether the key exists is for the reader to say.
PlacedEdit place_set_edit(const SetEdit& edit, const TomlText& values);

/// Throws UserError that points into an edit.
/// @param value whether to point at the value, or at the key
[[noreturn]] void refuse_set_edit(const std::string& argument, const std::string& message,
                                  bool value, const std::string& remedy);

} // namespace ionskin
