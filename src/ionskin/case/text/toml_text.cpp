// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/text/toml_text.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/case/text/toml_limits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <locale>
#include <optional>
#include <sstream>
#include <string>

namespace ionskin {

namespace {

// Removes the name of the function of toml11 from one of its messages.
std::string without_function_name(const std::string& message) {
  const std::string prefix = "[error]", library = "toml::";
  if (!message.starts_with(prefix))
    return message;
  std::size_t begin = message.find_first_not_of(' ', prefix.size());
  if (begin != std::string::npos && message.compare(begin, library.size(), library) == 0)
    begin = std::min(message.find(' ', begin), message.size());
  begin = message.find_first_not_of(' ', begin);
  return begin == std::string::npos ? "" : message.substr(begin);
}

std::size_t skip_blanks_back(const std::string& text, std::size_t end) {
  while (end > 0 && (text[end - 1] == ' ' || text[end - 1] == '\t'))
    --end;
  return end;
}

// Inserts newlines into a text at the given positions, between entries of lists, and returns their
// offsets in `breaks`. toml11 copies the whole line of every value, so that a long list in one line
// would take time quadratic in its length.
std::string with_breaks(const std::string& text, const std::vector<std::size_t>& positions,
                        std::vector<std::size_t>& breaks) {
  std::string parsed;
  parsed.reserve(text.size() + positions.size());
  std::size_t begin = 0;
  for (const std::size_t position : positions) {
    parsed.append(text, begin, position - begin);
    breaks.push_back(parsed.size());
    parsed += '\n';
    begin = position;
  }
  return parsed.append(text, begin);
}

// Returns the region of a value in its text. `toml::value::location` would be slow: it counts the
// lines before the value and copies its line.
const toml::detail::region* region_of(const toml::value& value) {
  return dynamic_cast<const toml::detail::region*>(toml::detail::get_region(value));
}

std::size_t offset_of(const std::string& text, const toml::source_location& where) {
  std::size_t line_begin = 0;
  for (std::size_t line = 1; line < where.line(); ++line)
    line_begin = text.find('\n', line_begin) + 1;
  return std::min<std::size_t>(line_begin + where.column() - 1, text.size());
}

/// True if the global std::locale has another decimal point than a dot, or groups thousands. toml11
/// parses numbers by streams, and would then read "0.3" as 3.
bool host_has_other_decimals() {
  const auto& marks = std::use_facet<std::numpunct<char>>(std::locale());
  return marks.decimal_point() != '.' || !marks.grouping().empty();
}

/// Parses all floating-point numbers of a tree again from their text, independent of the locale.
void read_decimals(toml::value& value) {
  if (value.is_table()) {
    for (auto& [key, entry] : value.as_table())
      read_decimals(entry);
  } else if (value.is_array()) {
    for (toml::value& entry : value.as_array())
      read_decimals(entry);
  } else if (value.is_floating()) {
    const toml::source_location where = value.location();
    std::string number = where.line_str().substr(where.column() - 1, where.region());
    std::erase(number, '_');
    const char* const begin = number.data() + (number.starts_with('+') ? 1 : 0);
    std::from_chars(begin, number.data() + number.size(), value.as_floating());
  }
}

constexpr const char* remedy_of_line =
    "lines read key = value; texts and quantities stand in quotes, numbers do not";

} // namespace

TomlText::TomlText(std::string text, const std::string& file)
    : text_(std::move(text)), file_(file) {
  const std::string parsed = with_breaks(text_, check_toml_limits(text_, file), breaks_);
  try {
    std::istringstream stream(parsed);
    root_ = toml::parse(stream, file);
    if (host_has_other_decimals())
      read_decimals(root_);
  } catch (const toml::exception& error) {
    refuse(error.what(), &error.location(), parsed);
  } catch (const std::exception& error) {
    refuse(error.what(), nullptr, parsed);
  }
}

TomlText TomlText::with_root(toml::value root) const {
  TomlText other = *this;
  other.root_ = std::move(root);
  return other;
}

void TomlText::refuse(const std::string& message, const toml::source_location* where,
                      const std::string& parsed) const {
  const std::string what = "the case is not valid TOML: " + without_function_name(message);
  if (breaks_.empty() || where == nullptr)
    throw UserError(fmt::format("{}\n  = {}", what, remedy_of_line));
  // The excerpt of toml11 would count the inserted newlines as lines.
  Problems problems;
  const std::size_t begin = in_text(offset_of(parsed, *where));
  problems.add(what.substr(0, what.find('\n')),
               {{CaseText(file_, text_).place(begin, where->region()), ""}}, remedy_of_line);
  problems.throw_if_any(file_);
  throw InternalError("a refused text was accepted");
}

std::size_t TomlText::in_text(std::size_t parsed) const {
  return parsed -
         static_cast<std::size_t>(std::ranges::lower_bound(breaks_, parsed) - breaks_.begin());
}

TextSpan TomlText::span(const toml::value& value) const {
  const toml::detail::region* region = region_of(value);
  if (region == nullptr)
    return {};
  const auto offset = [&](const auto& iterator) {
    return std::min(in_text(static_cast<std::size_t>(iterator - region->begin())), text_.size());
  };
  const std::size_t begin = offset(region->first());
  return {begin, offset(region->last()) - begin};
}

TextSpan TomlText::key_span(const toml::value& value) const {
  const TextSpan of_value = span(value);
  const std::size_t equals = skip_blanks_back(text_, of_value.begin);
  if (equals == 0 || text_[equals - 1] != '=')
    return of_value;
  const std::size_t end = skip_blanks_back(text_, equals - 1);
  std::size_t begin = end;
  while (begin > 0 &&
         std::string_view(" \t\n\r,{").find(text_[begin - 1]) == std::string_view::npos)
    --begin;
  return {begin, end - begin};
}

std::vector<std::pair<std::string, const toml::value*>>
TomlText::children_in_order(const toml::value& table) const {
  std::vector<std::pair<std::size_t, std::pair<std::string, const toml::value*>>> placed;
  for (const auto& [name, child] : table.as_table())
    placed.push_back({span(child).begin, {name, &child}});
  std::ranges::sort(placed, {}, [](const auto& child) { return child.first; });
  std::vector<std::pair<std::string, const toml::value*>> children;
  for (auto& [begin, child] : placed)
    children.push_back(std::move(child));
  return children;
}

} // namespace ionskin
