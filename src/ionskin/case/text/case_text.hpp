// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/text/place.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace ionskin {

/// Replacement of one span of the text of a case, as a `--set` edit makes it.
struct TextEdit {
  /// Offset of the span, in the text before all edits of one call of `CaseText::edit` [bytes].
  std::size_t begin = 0;
  std::size_t replaced = 0;    ///< length of the span [bytes]; 0 to insert
  std::string text;            ///< new text of the span
  std::size_t value_begin = 0; ///< offset of the key's value within `text` [bytes]
  std::string argument;        ///< the edit as the user wrote it, "contact.friction=0.3"
};

/// The text of a case file together with the `--set` edits made in it. It maps every position of
/// the edited text to where the user wrote it, in the file or in an edit, for error messages. A
/// lookup takes time logarithmic in the number of edits and lines. Positions are offsets in bytes.
class CaseText {
public:
  /// Starts with a text without edits.
  /// @param file name of the file, for messages
  CaseText(std::string file, std::string text);

  const std::string& file() const { return file_; } ///< name of the file, for messages
  /// The text with all edits so far.
  const std::string& text() const { return text_; }

  /// Applies several edits at once.
  /// @param edits ascending in `begin`, without overlap
  void edit(const std::vector<TextEdit>& edits);

  /// Finds where the user wrote the span [begin, begin + length) of the edited text: a line of the
  /// original file, or the key or value of an edit.
  Place place(std::size_t begin, std::size_t length) const;
  /// True if the text at this position of the edited text comes from an edit.
  bool is_edited(std::size_t position) const { return piece_at(position).is_edit; }

private:
  /// A contiguous part of the edited text from one origin. The pieces follow one another without
  /// gaps.
  struct Piece {
    std::size_t begin = 0; ///< offset in the edited text
    bool is_edit = false;  ///< true if it comes from an edit, false if from the original text
    /// Offset in the original text, or index of the edit in `arguments_`.
    std::size_t source = 0;
    bool is_value = false; ///< true for the value of an edit, false for its key
  };
  /// The piece that contains a position of the edited text.
  const Piece& piece_at(std::size_t position) const;

  std::string file_, original_, text_;
  std::vector<std::size_t> line_begins_; ///< offsets of the lines of the original text
  std::vector<Piece> pieces_;
  std::vector<std::string> arguments_;
};

/// Position of the key or of the value in a `--set` argument, for error messages.
/// @param argument as the user wrote it, "key=value"
/// @param value true for the value, false for the key
Place place_in_edit(const std::string& argument, bool value);

} // namespace ionskin
