// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/document/placed_edit.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/base/text.hpp"
#include "ionskin/case/document/set_edit.hpp"
#include "ionskin/case/text/toml_limits.hpp"

#include <fmt/format.h>

#include <charconv>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>

namespace ionskin {

namespace {

using Step = SetEdit::Step;
using Path = std::vector<Step>;

[[noreturn]] void refuse(const std::string& argument, const std::string& message, bool value,
                         const std::string& remedy) {
  refuse_set_edit(argument, message, value, remedy);
}

constexpr std::string_view name_letters =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-";

/// Parses one part of a key, "name" or "name[3]"; empty if it is malformed.
std::optional<Step> parse_step(const std::string& part) {
  const std::size_t open = std::min(part.find_first_not_of(name_letters), part.size());
  Step step{part.substr(0, open), {}};
  if (open == 0)
    return std::nullopt;
  if (open == part.size())
    return step;
  constexpr std::size_t most_digits = 6;
  const std::string digits = part.substr(open + 1, part.size() - open - 2);
  if (part[open] != '[' || part.back() != ']' || digits.empty() || digits.size() > most_digits ||
      digits.find_first_not_of("0123456789") != std::string::npos)
    return std::nullopt;
  step.index = std::stoul(digits);
  return step;
}

Path parse_path(const std::string& argument, const std::string& key) {
  Path path;
  std::istringstream parts(key);
  for (std::string part; std::getline(parts, part, '.');) {
    const std::optional<Step> step = parse_step(part);
    if (!step)
      refuse(argument, fmt::format("\"{}\" is not a key", base::shown(key)), false,
             "keys look like contact.friction or skin.layers[1].thickness");
    path.push_back(*step);
  }
  if (path.empty() || key.ends_with('.'))
    refuse(argument, "the edit names no key", false, "write --set key=value");
  return path;
}

bool is_toml_value(const std::string& text) {
  try {
    const TomlText line("value = " + text, "");
    // The value must be the whole text: a comment behind it would hide the rest of an inline table.
    return line.root().as_table().size() == 1 &&
           line.span(line.root().as_table().at("value")).length == text.size();
  } catch (const UserError&) {
    return false;
  }
}

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char letter : text) {
    if (letter == '"' || letter == '\\')
      result += '\\';
    result += letter;
  }
  return result + "\"";
}

std::string array_text(const std::string& typed) {
  std::istringstream items(typed.substr(1, typed.size() - 2));
  std::string result;
  for (std::string item; std::getline(items, item, ',');)
    result += (result.empty() ? "" : ", ") + toml_value_text(base::trimmed(item));
  return "[" + result + "]";
}

// The deepest existing value on the path of a key, and the number of steps that lead to it.
struct Descent {
  const toml::value* value = nullptr;
  std::size_t steps = 0;
};

const toml::value& element(const std::string& argument, const toml::value& array,
                           const Step& step) {
  if (!array.is_array() || *step.index >= array.as_array().size())
    refuse(argument, fmt::format("{} has no entry {}", step.name, *step.index), false,
           array.is_array()
               ? fmt::format("it has {} entries, counted from 0", array.as_array().size())
               : fmt::format("{} is not an array", step.name));
  return array.as_array()[*step.index];
}

enum class Indices { left_out, written };

std::string dotted(Path::const_iterator begin, Path::const_iterator end,
                   Indices indices = Indices::left_out) {
  std::string key;
  for (auto step = begin; step != end; ++step) {
    key += (key.empty() ? "" : ".") + step->name;
    if (step->index && indices == Indices::written)
      key += fmt::format("[{}]", *step->index);
  }
  return key;
}

/// Index of the entry of a list of tables, such as the layers, whose key `name` has this value.
std::optional<std::size_t> entry_named(const toml::array& entries, const std::string& name) {
  for (std::size_t i = 0; i < entries.size(); ++i)
    if (entries[i].is_table() && entries[i].contains("name") && entries[i].at("name").is_string() &&
        entries[i].at("name").as_string().str == name)
      return i;
  return std::nullopt;
}

/// Refuses an edit whose path continues with `step` below a list or a single value instead of a
/// table.
[[noreturn]] void refuse_step(const std::string& argument, const toml::value& value,
                              const Path& path, Path::const_iterator step) {
  const std::string key = dotted(path.begin(), step, Indices::written), &name = (step - 1)->name;
  if (!value.is_array())
    refuse(argument, fmt::format("{} is a value, not a table", name), false,
           fmt::format("set it by {}=VALUE", key));
  const bool counts = step->name.find_first_not_of("0123456789") == std::string::npos;
  const std::optional<std::size_t> named = entry_named(value.as_array(), step->name);
  const auto entry = counts || named ? step + 1 : step;
  refuse(argument, fmt::format("{} is a list, not a table", name), false,
         fmt::format("its entries, {} in all, are counted from 0: {}[{}]{}{}",
                     value.as_array().size(), key,
                     counts ? step->name : std::to_string(named.value_or(0)),
                     entry == path.end() ? "" : ".", dotted(entry, path.end(), Indices::written)));
}

Descent descend(const std::string& argument, const toml::value& root, const Path& path) {
  Descent descent{&root, 0};
  for (auto step = path.begin(); step != path.end(); ++step) {
    if (!descent.value->is_table())
      refuse_step(argument, *descent.value, path, step);
    const auto& table = descent.value->as_table();
    const auto found = table.find(step->name);
    if (found == table.end())
      return descent;
    descent.value = step->index ? &element(argument, found->second, *step) : &found->second;
    ++descent.steps;
  }
  return descent;
}

std::size_t line_end(const std::string& text, std::size_t position) {
  return std::min(text.find('\n', position), text.size());
}

// Position at which a new key can be inserted, and the text around "key = value" there.
struct Slot {
  std::size_t position = 0;
  std::string before, key, after;
  std::string claim; ///< see `PlacedEdit::claim`; empty for the new key itself
  bool on_top = true;
};

Slot slot_at_end(const std::string& text, const std::string& table, const std::string& key) {
  const std::string gap = text.empty() || text.ends_with('\n') ? "\n" : "\n\n";
  // The claim is the outermost table, because the new header creates all tables that contain it.
  return {text.size(), fmt::format("{}[{}]\n", gap, table), key,
          "\n",        table.substr(0, table.find('.')),    false};
}

/// Inserts the header of a table before the list of tables, such as [[readout.taxels]], that is all
/// the table has so far. TOML does not allow the header behind the list.
Slot slot_before_list(const std::string& text, std::size_t first, const std::string& table,
                      const std::string& key) {
  const std::size_t line = first == 0 ? 0 : text.rfind('\n', first - 1) + 1;
  return {line, fmt::format("[{}]\n", table), key, "\n\n", table, false};
}

Slot slot_after_line(const std::string& text, std::size_t position, const std::string& key) {
  return {line_end(text, position), "\n", key, "", ""};
}

// Inserts a new key in dotted form beside a key of the same table such as `contact.law = ...`: TOML
// then does not allow a header [contact].
Slot slot_beside_dotted(const std::string& argument, const TomlText& values,
                        const toml::value& table, const std::string& new_key) {
  const std::string& text = values.text();
  const toml::value* leaf = &table;
  std::size_t depth = 0;
  for (; leaf->is_table() && !leaf->as_table().empty(); ++depth)
    leaf = &leaf->as_table().begin()->second;
  const TextSpan span = values.key_span(*leaf);
  std::string prefix = text.substr(span.begin, span.length);
  for (std::size_t i = 0; i < depth && prefix.find('.') != std::string::npos; ++i)
    prefix.erase(prefix.rfind('.'));
  const std::size_t line_begin = span.begin == 0 ? 0 : text.rfind('\n', span.begin - 1) + 1;
  if (!base::trimmed(text.substr(line_begin, span.begin - line_begin)).empty())
    refuse(argument, "this key cannot be added inside the inline table of the file", false,
           "write it in the file");
  const TextSpan value = values.span(*leaf);
  return slot_after_line(text, value.begin + value.length, prefix + "." + new_key);
}

Slot find_slot(const std::string& argument, const TomlText& values, const Descent& descent,
               const Path& path) {
  const std::string& text = values.text();
  const auto missing = path.begin() + static_cast<std::ptrdiff_t>(descent.steps);
  for (auto step = missing; step != path.end(); ++step)
    if (step->index)
      refuse(argument, fmt::format("the case has no array {}", dotted(path.begin(), step + 1)),
             false, "write the array in the file");
  const std::string rest = dotted(missing, path.end());
  if (descent.steps == 0)
    return path.size() == 1
               ? Slot{0, "", rest, "\n", ""}
               : slot_at_end(text, dotted(path.begin(), path.end() - 1), path.back().name);
  const toml::value& table = *descent.value;
  const TextSpan span = values.span(table);
  const std::string written = text.substr(span.begin, span.length);
  const std::string name = dotted(path.begin(), missing);
  if (written.starts_with('{')) {
    const bool empty = table.as_table().empty();
    return {span.begin + span.length - 1,
            empty ? "" : ", ",
            rest,
            "",
            empty ? dotted(path.begin(), missing, Indices::written) : "",
            false};
  }
  if (written == "[" + name + "]" || written == "[[" + name + "]]")
    return slot_after_line(text, span.begin, rest);
  if (written.starts_with("[["))
    return slot_before_list(text, span.begin, name, rest);
  if (written.starts_with('['))
    return slot_at_end(text, name,
                       rest); // the table has only sub-tables such as [materials.platinum]
  return slot_beside_dotted(argument, values, table, rest);
}

bool is_headed(const TomlText& values, const toml::value& value) {
  const std::size_t begin = values.span(value).begin;
  if (value.is_table())
    return begin >= values.text().size() || values.text()[begin] != '{';
  const bool table_list =
      value.is_array() && !value.as_array().empty() && value.as_array().front().is_table();
  return table_list && begin == values.span(value.as_array().front()).begin;
}

} // namespace

std::string toml_value_text(const std::string& typed) {
  if (is_toml_value(typed))
    return typed;
  if (typed.size() >= 2 && typed.front() == '[' && typed.back() == ']')
    return array_text(typed);
  return quoted(typed);
}

namespace {

/// Checks length, encoding and depth of an edit before it is parsed.
void check_limits(const std::string& argument) {
  if (argument.size() > toml_limits::text_bytes)
    refuse(argument, fmt::format("the edit has {} bytes", argument.size()), false,
           fmt::format("it may have {}", toml_limits::text_bytes));
  if (!base::is_utf8(argument))
    refuse(argument, "the edit is not UTF-8", false, "write --set key=value in UTF-8");
  std::size_t depth = 0, deepest = 0;
  for (const char letter : argument) {
    depth += letter == '[' || letter == '{' ? 1 : 0;
    depth -= depth > 0 && (letter == ']' || letter == '}') ? 1 : 0;
    deepest = std::max(deepest, depth);
  }
  if (deepest > toml_limits::depth)
    refuse(argument, fmt::format("more than {} brackets stand in one another", toml_limits::depth),
           true, "no key of a case needs more than 3");
}

} // namespace

void refuse_set_edit(const std::string& argument, const std::string& message, bool value,
                     const std::string& remedy) {
  Problems problems;
  problems.add(message, {{place_in_edit(argument, value), ""}}, remedy);
  problems.throw_if_any("--set");
  throw InternalError("a refused edit was accepted");
}

SetEdit parse_set_edit(const std::string& argument) {
  check_limits(argument);
  const std::size_t equals = argument.find('=');
  if (equals == std::string::npos)
    refuse(argument, "the edit has no value", false, "write --set key=value");
  const std::string key = base::trimmed(argument.substr(0, equals));
  const std::string typed = base::trimmed(argument.substr(equals + 1));
  if (typed.empty() || typed.find('\n') != std::string::npos)
    refuse(argument, typed.empty() ? "the edit has no value" : "the value has several lines", true,
           "write --set key=value; an empty text is \"\"");
  const std::string value = toml_value_text(typed);
  if (!is_toml_value(value))
    refuse(argument, fmt::format("{} is not a TOML value", base::shown(typed)), true,
           "numbers, quantities such as 3 mm, words, \"texts\" and [lists] are");
  return {argument, parse_path(argument, key), value};
}

std::vector<std::string> SetEdit::tables_and_key() const {
  std::vector<std::string> names;
  std::string name;
  for (const Step& step : path) {
    name += (name.empty() ? "" : ".") + step.name;
    names.push_back(name);
    if (step.index)
      names.push_back(name += fmt::format("[{}]", *step.index));
  }
  return names;
}

PlacedEdit place_set_edit(const SetEdit& edit, const TomlText& values) {
  const std::string& argument = edit.argument;
  const Descent descent = descend(argument, values.root(), edit.path);
  const std::string key = dotted(edit.path.begin(), edit.path.end(), Indices::written);
  if (descent.steps == edit.path.size()) {
    if (is_headed(values, *descent.value))
      refuse(argument, key + " is a table; its keys can be set one by one", false,
             fmt::format("write --set {}.KEY=VALUE", key));
    const TextSpan span = values.span(*descent.value);
    return {{span.begin, span.length, edit.value, 0, argument}, key, false};
  }
  const Slot slot = find_slot(argument, values, descent, edit.path);
  const std::string head = slot.before + slot.key + " = ";
  const auto made = edit.path.begin() + static_cast<std::ptrdiff_t>(descent.steps) + 1;
  return {{slot.position, 0, head + edit.value + slot.after, head.size(), argument},
          slot.claim.empty() ? dotted(edit.path.begin(), made, Indices::written) : slot.claim,
          slot.on_top};
}

} // namespace ionskin
