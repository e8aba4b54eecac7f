// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/text/place.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace ionskin {

/// A span of the text that a `--set` edit replaces.
struct TextEdit {
  std::size_t begin = 0;       ///< in the text before the edits made with it
  std::size_t replaced = 0;    ///< bytes that stand there; 0 to insert
  std::string text;            ///< text that stands there instead
  std::size_t value_begin = 0; ///< start of the edit's value within `text`
  std::string argument;        ///< the edit as the user wrote it, "contact.friction=0.3"
};

/// The text of a case file together with the `--set` edits made in it, so that every position in
/// the edited text can be shown where the user wrote it: in the file, or in the edit. A position is
/// found in the logarithm of the number of edits and lines.
class CaseText {
public:
  /// @param file name shown in messages
  CaseText(std::string file, std::string text);

  const std::string& file() const { return file_; }
  /// Text with all edits so far.
  const std::string& text() const { return text_; }

  /// Makes several edits at once.
  /// @param edits by ascending begin; they must not overlap
  void edit(const std::vector<TextEdit>& edits);

  /// Where the user wrote the span [begin, begin + length) of the edited text.
  Place place(std::size_t begin, std::size_t length) const;
  /// True when an edit wrote the text at this position.
  bool is_edited(std::size_t position) const { return piece_at(position).is_edit; }

private:
  /// The edited text consists of these, one behind the other.
  struct Piece {
    std::size_t begin = 0; ///< in the edited text
    bool is_edit = false;
    std::size_t source =
        0; ///< place where it begins in the original, or the index of the edit's argument
    bool is_value = false; ///< of an edit: the value, not the key
  };
  const Piece& piece_at(std::size_t position) const;

  std::string file_, original_, text_;
  std::vector<std::size_t> line_begins_; ///< of the original
  std::vector<Piece> pieces_;
  std::vector<std::string> arguments_;
};

/// A place in a `--set` argument "key=value": the value, or the key.
Place place_in_edit(const std::string& argument, bool value);

} // namespace ionskin
