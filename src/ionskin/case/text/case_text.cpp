// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/text/case_text.hpp"

#include <algorithm>

namespace ionskin {

CaseText::CaseText(std::string file, std::string text)
    : file_(std::move(file)), original_(text),
      text_(std::move(text)), line_begins_{0}, pieces_{{}} {
  for (std::size_t end = original_.find('\n'); end != std::string::npos;
       end = original_.find('\n', end + 1))
    line_begins_.push_back(end + 1);
}

void CaseText::edit(const std::vector<TextEdit>& edits) {
  std::string text;
  std::vector<Piece> pieces;
  std::size_t at = 0, piece = 0;
  const auto keep_until = [&](std::size_t end) {
    for (; at < end; ++piece) {
      const std::size_t piece_end =
          piece + 1 < pieces_.size() ? pieces_[piece + 1].begin : text_.size();
      if (piece_end <= at)
        continue;
      Piece kept = pieces_[piece];
      kept.source += kept.is_edit ? 0 : at - kept.begin;
      kept.begin = text.size();
      pieces.push_back(kept);
      text.append(text_, at, std::min(piece_end, end) - at);
      at = std::min(piece_end, end);
      if (piece_end > end)
        return;
    }
  };
  for (const TextEdit& edit : edits) {
    keep_until(edit.begin);
    if (edit.value_begin > 0)
      pieces.push_back({text.size(), true, arguments_.size(), false});
    pieces.push_back({text.size() + edit.value_begin, true, arguments_.size(), true});
    arguments_.push_back(edit.argument);
    text += edit.text;
    at = edit.begin + edit.replaced;
  }
  keep_until(text_.size());
  text_ = std::move(text);
  pieces_ = std::move(pieces);
}

const CaseText::Piece& CaseText::piece_at(std::size_t position) const {
  const auto next = std::ranges::upper_bound(pieces_, position, {}, &Piece::begin);
  return next == pieces_.begin() ? *next : *(next - 1);
}

Place CaseText::place(std::size_t begin, std::size_t length) const {
  const Piece& piece = piece_at(begin);
  if (piece.is_edit)
    return place_in_edit(arguments_[piece.source], piece.is_value);
  const std::size_t position = std::min(piece.source + begin - piece.begin, original_.size());
  const auto next_line = std::ranges::upper_bound(line_begins_, position);
  const std::size_t line_begin = *(next_line - 1);
  std::size_t line_end = next_line == line_begins_.end() ? original_.size() : *next_line - 1;

  Place place;
  place.origin = file_;
  place.line = static_cast<std::size_t>(next_line - line_begins_.begin());
  place.column = position - line_begin + 1;
  place.length = std::min(length, line_end - position);
  if (line_end > line_begin && original_[line_end - 1] == '\r')
    --line_end;
  // Only a part of a long line is stored: every entry of a long list in one line has a position.
  constexpr std::size_t kept = 400;
  place.cut = position > line_begin + kept ? position - line_begin - kept : 0;
  const std::size_t shown_end = std::min(line_end, position + std::min(place.length, kept) + kept);
  place.line_text = original_.substr(
      line_begin + place.cut, std::max(line_begin + place.cut, shown_end) - line_begin - place.cut);
  return place;
}

Place place_in_edit(const std::string& argument, bool value) {
  const std::size_t equals = std::min(argument.find('='), argument.size());
  const std::string option = "--set ";
  Place place{"command line", 0, option.size() + 1, equals, option + argument};
  if (value && equals < argument.size()) {
    place.column = option.size() + equals + 2;
    place.length = argument.size() - equals - 1;
  }
  return place;
}

} // namespace ionskin
