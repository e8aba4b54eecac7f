// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/text/case_text.hpp"

#include <algorithm>

namespace ionskin {

CaseText::CaseText(std::string file, std::string text)
    : file_(std::move(file)), original_(text), text_(std::move(text)) {}

void CaseText::edit(std::size_t begin, std::size_t replaced, const std::string& text,
                    std::size_t value_begin, const std::string& argument) {
  Insertion insertion{begin, text.size(), replaced, value_begin, argument, false};
  for (Insertion& earlier : insertions_) {
    if (earlier.begin >= begin + replaced) {
      earlier.begin = earlier.begin + text.size() - replaced;
    } else if (earlier.begin <= begin && begin < earlier.begin + earlier.length) {
      earlier.length = earlier.length + text.size() - replaced;
      insertion.nested = true;
    }
  }
  text_.replace(begin, replaced, text);
  insertions_.push_back(insertion);
}

const CaseText::Insertion* CaseText::insertion_at(std::size_t position) const {
  const auto holds = [&](const Insertion& insertion) {
    return insertion.begin <= position && position < insertion.begin + insertion.length;
  };
  // The latest edit of a stretch is the one that counts.
  const auto found = std::find_if(insertions_.rbegin(), insertions_.rend(), holds);
  return found == insertions_.rend() ? nullptr : &*found;
}

Place CaseText::place(std::size_t begin, std::size_t length) const {
  if (const Insertion* insertion = insertion_at(begin))
    return place_in_edit(insertion->argument, begin >= insertion->begin + insertion->value_begin);
  std::size_t position = begin;
  for (const Insertion& insertion : insertions_)
    if (!insertion.nested && insertion.begin < begin)
      position = position + insertion.replaced - insertion.length;
  position = std::min(position, original_.size());

  Place place;
  place.origin = file_;
  place.line = static_cast<std::size_t>(
      1 + std::count(original_.begin(), original_.begin() + static_cast<std::ptrdiff_t>(position),
                     '\n'));
  const std::size_t line_begin = position == 0 ? 0 : original_.rfind('\n', position - 1) + 1;
  const std::size_t line_end = std::min(original_.find('\n', position), original_.size());
  place.line_text = original_.substr(line_begin, line_end - line_begin);
  if (place.line_text.ends_with('\r'))
    place.line_text.pop_back();
  place.column = position - line_begin + 1;
  place.length = std::min(length, line_end - position);
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
