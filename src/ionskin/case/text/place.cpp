// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/text/place.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/base/text.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace ionskin {

namespace {

constexpr std::size_t most_shown = 10;

bool starts_code_point(char byte) {
  return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U;
}

// Makes blanks as wide as a text on a terminal: tabs stay, every other code point becomes a blank.
std::string blanks_under(const std::string& text) {
  std::string blanks;
  for (const char byte : text)
    if (starts_code_point(byte))
      blanks += byte == '\t' ? '\t' : ' ';
  return blanks;
}

// The part of a line that is shown, in printable form: before, at and after the marked span.
struct Window {
  std::string before, marked, after;
};

Window window_of(const std::string& line, std::size_t column, std::size_t length) {
  constexpr std::size_t margin = 80, most_marked = 120;
  const auto to_start = [&](std::size_t position) {
    while (position > 0 && position < line.size() && !starts_code_point(line[position]))
      --position;
    return position;
  };
  const std::size_t begin = to_start(column > margin ? column - margin : 0);
  const std::size_t marked_end =
      to_start(std::min(column + std::min(length, most_marked), line.size()));
  const std::size_t end = to_start(std::min(marked_end + margin, line.size()));
  const auto part = [&](std::size_t from, std::size_t to) {
    return base::printable(line.substr(from, std::max(from, to) - from));
  };
  return {(begin > 0 ? "..." : "") + part(begin, column), part(column, marked_end),
          part(marked_end, end) + (end < line.size() ? "..." : "")};
}

} // namespace

std::string excerpt(const Pointer& pointer) {
  const Place& place = pointer.place;
  const std::size_t column = std::min(place.column - 1 - place.cut, place.line_text.size());
  const auto [before, marked, after] = window_of(place.line_text, column, place.length);
  const auto width =
      static_cast<std::size_t>(std::count_if(marked.begin(), marked.end(), starts_code_point));
  const std::string number = place.line == 0 ? "" : std::to_string(place.line);
  const std::string margin = blanks_under(number);
  const std::string where = place.line == 0
                                ? place.origin
                                : fmt::format("{}:{}:{}", base::shown(place.origin, 200),
                                              place.line, place.cut + column + 1);
  const std::string indent = blanks_under(before);
  return fmt::format("{0} --> {1}\n {0} |\n {2} | {3}\n {0} | {4}{5:^>{6}}{7}", margin, where,
                     number, before + marked + after, indent, "", std::max<std::size_t>(width, 1),
                     pointer.note.empty() ? "" : fmt::format(" {}", pointer.note));
}

bool Problems::full() const {
  return texts_.size() >= most_shown;
}

void Problems::add(const std::string& message, const std::vector<Pointer>& pointers,
                   const std::string& remedy) {
  if (full()) {
    texts_.emplace_back(); // only counted
    return;
  }
  std::string text = message;
  for (const Pointer& pointer : pointers)
    text.append("\n").append(excerpt(pointer));
  if (!remedy.empty())
    text.append("\n  = ").append(remedy);
  texts_.push_back(text);
}

void Problems::throw_if_any(const std::string& file) const {
  if (texts_.empty())
    return;
  if (texts_.size() == 1)
    throw UserError(base::printable(texts_.front()));
  std::string all = fmt::format("{} problems in {}", texts_.size(), base::shown(file));
  const std::size_t shown = std::min(texts_.size(), most_shown);
  for (std::size_t i = 0; i < shown; ++i)
    all += fmt::format("\n\n({}) {}", i + 1, texts_[i]);
  if (shown < texts_.size())
    all += fmt::format("\n\nand {} more, shown once these are mended", texts_.size() - shown);
  throw UserError(base::printable(all));
}

} // namespace ionskin
