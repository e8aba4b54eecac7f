// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/text/toml_text.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/case/text/toml_limits.hpp"

#include <algorithm>
#include <sstream>

namespace ionskin {

namespace {

// toml11's parser is instantiated here alone: it takes long to compile.
toml::value parse(const std::string& text, const std::string& file) {
  check_toml_limits(text, file);
  std::istringstream stream(text);
  return toml::parse(stream, file);
}

// toml11 names its own functions in its messages; users need not see them.
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

} // namespace

std::optional<toml::value> try_parse_toml(const std::string& text) {
  try {
    return parse(text, "");
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

toml::value parse_toml(const std::string& text, const std::string& file) {
  try {
    return parse(text, file);
  } catch (const UserError&) {
    throw;
  } catch (const std::exception& error) {
    throw UserError(
        "the case is not valid TOML: " + without_function_name(error.what()) +
        "\n  = lines read key = value; texts and quantities stand in quotes, numbers do not");
  }
}

TextSpan value_span(const std::string& text, const toml::value& value) {
  const toml::source_location location = value.location();
  std::size_t line_begin = 0;
  for (std::size_t line = 1; line < location.line(); ++line)
    line_begin = text.find('\n', line_begin) + 1;
  const std::size_t begin = std::min<std::size_t>(line_begin + location.column() - 1, text.size());
  return {begin, std::min<std::size_t>(location.region(), text.size() - begin)};
}

TextSpan key_span(const std::string& text, const toml::value& value) {
  const TextSpan span = value_span(text, value);
  const std::size_t equals = skip_blanks_back(text, span.begin);
  if (equals == 0 || text[equals - 1] != '=')
    return span;
  const std::size_t end = skip_blanks_back(text, equals - 1);
  std::size_t begin = end;
  while (begin > 0 && std::string_view(" \t\n\r,{").find(text[begin - 1]) == std::string_view::npos)
    --begin;
  return {begin, end - begin};
}

std::vector<std::pair<std::string, const toml::value*>>
children_in_order(const std::string& text, const toml::value& table) {
  // A span costs a walk over the text: one for each child.
  std::vector<std::pair<std::size_t, std::pair<std::string, const toml::value*>>> placed;
  for (const auto& [name, child] : table.as_table())
    placed.push_back({value_span(text, child).begin, {name, &child}});
  std::ranges::sort(placed, {}, [](const auto& child) { return child.first; });
  std::vector<std::pair<std::string, const toml::value*>> children;
  for (auto& [begin, child] : placed)
    children.push_back(std::move(child));
  return children;
}

bool has_header(const std::string& text, const toml::value& table) {
  const TextSpan span = value_span(text, table);
  return span.begin < text.size() && text[span.begin] == '[';
}

} // namespace ionskin
