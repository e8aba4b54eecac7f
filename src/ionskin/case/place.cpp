// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/place.hpp"

#include "ionskin/base/error.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace ionskin {

namespace {

bool starts_code_point(char byte) {
  return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U;
}

// Blanks as wide as the text on a terminal: tabs stay, one blank per code point otherwise.
std::string blanks_under(const std::string& text) {
  std::string blanks;
  for (const char byte : text)
    if (starts_code_point(byte))
      blanks += byte == '\t' ? '\t' : ' ';
  return blanks;
}

} // namespace

std::string excerpt(const Pointer& pointer) {
  const Place& place = pointer.place;
  const std::size_t column = std::min(place.column - 1, place.line_text.size());
  const std::string marked = place.line_text.substr(column, place.length);
  const auto width =
      static_cast<std::size_t>(std::count_if(marked.begin(), marked.end(), starts_code_point));
  const std::string number = place.line == 0 ? "" : std::to_string(place.line);
  const std::string margin = blanks_under(number);
  const std::string where = place.line == 0
                                ? place.origin
                                : fmt::format("{}:{}:{}", place.origin, place.line, column + 1);
  const std::string indent = blanks_under(place.line_text.substr(0, column));
  return fmt::format("{0} --> {1}\n {0} |\n {2} | {3}\n {0} | {4}{5:^>{6}}{7}", margin, where,
                     number, place.line_text, indent, "", std::max<std::size_t>(width, 1),
                     pointer.note.empty() ? "" : fmt::format(" {}", pointer.note));
}

void Problems::add(const std::string& message, const std::vector<Pointer>& pointers,
                   const std::string& remedy) {
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
    throw UserError(texts_.front());
  std::string all = fmt::format("{} problems in {}", texts_.size(), file);
  for (std::size_t i = 0; i < texts_.size(); ++i)
    all += fmt::format("\n\n({}) {}", i + 1, texts_[i]);
  throw UserError(all);
}

} // namespace ionskin
