// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/text/place.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace ionskin {

/// The text of a case file together with the `--set` edits made in it, so that every position in
/// the edited text can be shown where the user wrote it: in the file, or in the edit.
class CaseText {
public:
  /// @param file name shown in messages
  CaseText(std::string file, std::string text);

  const std::string& file() const { return file_; }
  /// With all edits so far.
  const std::string& text() const { return text_; }

  /// One stretch of text written by an edit.
  struct Insertion {
    std::size_t begin = 0;       ///< in the edited text
    std::size_t length = 0;      ///< in the edited text
    std::size_t replaced = 0;    ///< bytes that stood there before
    std::size_t value_begin = 0; ///< where the value starts within the insertion
    std::string argument;        ///< "contact.friction=0.3"
    bool nested = false;         ///< lies inside an earlier insertion
  };

  /// Replaces `replaced` bytes at `begin` by `text`.
  /// @param value_begin where the edit's value starts within `text`
  /// @param argument the edit as the user wrote it, "key=value"
  void edit(std::size_t begin, std::size_t replaced, const std::string& text,
            std::size_t value_begin, const std::string& argument);

  /// Where the user wrote the stretch [begin, begin + length) of the edited text.
  Place place(std::size_t begin, std::size_t length) const;
  /// True when an edit wrote the text at this position.
  bool is_edited(std::size_t position) const { return insertion_at(position) != nullptr; }

private:
  const Insertion* insertion_at(std::size_t position) const;

  std::string file_, original_, text_;
  std::vector<Insertion> insertions_;
};

/// A place in a `--set` argument "key=value": the value, or the key.
Place place_in_edit(const std::string& argument, bool value);

} // namespace ionskin
