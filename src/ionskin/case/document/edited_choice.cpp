// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/document/edited_choice.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/base/text.hpp"
#include "ionskin/case/document/toml_walk.hpp"
#include "ionskin/case/schema/schema.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string_view>
#include <utility>

namespace ionskin {

namespace {

bool is_idle(const SchemaRow& row, const Case& before, const Case& now) {
  return row.applies && !row.may_stand && row.applies(before) && !row.applies(now);
}

/// Finds the value of a key such as "motion.waypoints[0].time"; nullptr if there is none, or if a
/// quoted name contains dots.
const toml::value* value_of(const TomlText& values, std::string_view key) {
  const toml::value* value = &values.root();
  while (!key.empty()) {
    const std::size_t end = std::min(key.find('.'), key.size());
    const std::string_view step = key.substr(0, end);
    const std::size_t open = std::min(step.find('['), step.size());
    if (!value->is_table())
      return nullptr;
    const auto found = value->as_table().find(std::string(step.substr(0, open)));
    if (found == value->as_table().end())
      return nullptr;
    value = &found->second;
    if (open < step.size()) {
      const std::size_t index = std::stoul(std::string(step.substr(open + 1)));
      if (!value->is_array() || index >= value->as_array().size())
        return nullptr;
      value = &value->as_array()[index];
    }
    key.remove_prefix(std::min(end + 1, key.size()));
  }
  return value;
}

/// Finds the span of a statement "key = value", or of the header of a table.
TextSpan statement(const TomlText& values, const toml::value& value) {
  const TextSpan key = values.key_span(value), own = values.span(value);
  return {key.begin, own.begin + own.length - key.begin};
}

std::size_t line_begin(const std::string& text, std::size_t position) {
  const std::size_t before = position == 0 ? std::string::npos : text.rfind('\n', position - 1);
  return before == std::string::npos ? 0 : before + 1;
}

/// True if the lines of a statement contain nothing else but comments.
bool has_lines_of_its_own(const std::string& text, const TextSpan& span) {
  const std::size_t begin = line_begin(text, span.begin), end = span.begin + span.length;
  const std::string behind =
      base::trimmed(text.substr(end, std::min(text.find('\n', end), text.size()) - end));
  return base::trimmed(text.substr(begin, span.begin - begin)).empty() &&
         (behind.empty() || behind.front() == '#');
}

/// Extends the span of a statement in an inline table by the comma that must be removed with it.
TextSpan with_comma(const std::string& text, TextSpan span) {
  const std::size_t behind =
      std::min(text.find_first_not_of(" \t", span.begin + span.length), text.size());
  if (behind < text.size() && text[behind] == ',') {
    const std::size_t next = std::min(text.find_first_not_of(" \t", behind + 1), text.size());
    return {span.begin, next - span.begin};
  }
  const std::size_t before = text.find_last_not_of(" \t", span.begin - 1);
  if (before != std::string::npos && text[before] == ',') {
    return {before, span.begin + span.length - before};
  }
  return span;
}

/// Applies edits to a text, unless the result is not TOML: then the text stays as it is.
void write(CaseText& text, TomlText& values, const std::vector<TextEdit>& edits) {
  CaseText trial = text;
  trial.edit(edits);
  try {
    values = TomlText(trial.text(), trial.file());
    text = std::move(trial);
  } catch (const UserError&) { // the key stays, and the checks refuse it
    return;
  }
}

/// Keys of the file that have lost their effect: `names` for the user, and `statements`, the keys
/// whose text is to be left out. A list of tables has one name, and the statements of every table.
struct Idle {
  std::vector<std::string> names, statements;
};

Idle find_idle(const TomlText& values, const TomlWalk& edited, const Case& before) {
  Idle idle;
  std::set<std::string> lists;
  for (const ValueRecord& record : edited.records) {
    const SchemaRow* row = find_row(key_pattern(record.key));
    if (record.origin != ValueOrigin::file || row == nullptr ||
        !is_idle(*row, before, edited.draft.input) || value_of(values, record.key) == nullptr)
      continue;
    const std::size_t brackets = row->key.find("[]");
    if (brackets == std::string::npos) {
      idle.names.push_back(record.key);
      idle.statements.push_back(record.key);
      continue;
    }
    const std::string list = row->key.substr(0, brackets);
    const std::string entry = record.key.substr(0, record.key.find(']') + 1);
    const TextSpan table = values.span(*value_of(values, entry));
    const bool headed = values.text().compare(table.begin, 2, "[[") == 0;
    if (lists.insert(list).second) {
      idle.names.push_back(list);
      if (!headed)
        idle.statements.push_back(list);
    }
    if (headed) {
      if (lists.insert(entry).second)
        idle.statements.push_back(entry);
      idle.statements.push_back(record.key);
    }
  }
  return idle;
}

void leave_out(CaseText& text, TomlText& values, const std::vector<std::string>& statements) {
  std::set<std::size_t> lines;
  std::vector<std::string> inlined;
  for (const std::string& key : statements) {
    const TextSpan span = statement(values, *value_of(values, key));
    if (!has_lines_of_its_own(text.text(), span)) {
      inlined.push_back(key);
      continue;
    }
    const std::size_t end = span.begin + span.length;
    for (std::size_t line = line_begin(text.text(), span.begin); line < end;) {
      lines.insert(line);
      const std::size_t next = text.text().find('\n', line);
      line = next == std::string::npos ? end : next + 1;
    }
  }
  std::vector<TextEdit> edits;
  for (const std::size_t line : lines)
    edits.push_back({line, 0, "# ", 0, ""});
  if (!edits.empty())
    write(text, values, edits);
  for (const std::string& key : inlined) {
    const TextSpan span = with_comma(text.text(), statement(values, *value_of(values, key)));
    write(text, values, {{span.begin, span.length, "", 0, ""}});
  }
}

/// True if an edit sets a key of type `choice` or a table, which may contain one. Most edits set
/// numbers.
bool may_choose(const std::string& edit) {
  const SchemaRow* row = find_row(key_pattern(base::trimmed(edit.substr(0, edit.find('=')))));
  return row == nullptr || row->type == ValueType::choice;
}

/// True if a record is a choice that an edit set, except for those in [numerics], which say only
/// how finely the case is solved.
bool is_edited_choice(const ValueRecord& record) {
  const SchemaRow* row = find_row(key_pattern(record.key));
  return record.origin == ValueOrigin::set_edit && row != nullptr &&
         row->type == ValueType::choice && !record.key.starts_with("numerics.");
}

} // namespace

std::optional<EditedChoices> fit_to_edited_choices(CaseText& text, TomlText& values,
                                                   const std::string& original,
                                                   const std::vector<std::string>& set_edits) {
  if (std::ranges::none_of(set_edits, may_choose))
    return std::nullopt;
  Problems ignored; // the walk that reads the case reports the same mistakes
  TomlWalk edited(text, values, ignored);
  edited.visit();
  EditedChoices found;
  for (const ValueRecord& record : edited.records)
    if (is_edited_choice(record)) {
      found.words +=
          fmt::format("{}{} = {}", found.words.empty() ? "" : ", ", record.key, record.written);
      found.places.push_back({*record.place, ""});
    }
  if (found.places.empty())
    return std::nullopt;
  const CaseText text_before(text.file(), original);
  const TomlText values_before(original, text.file());
  TomlWalk before(text_before, values_before, ignored);
  before.visit();
  found.before = std::move(before.draft.input);
  Idle idle = find_idle(values, edited, found.before);
  leave_out(text, values, idle.statements);
  found.left_out = std::move(idle.names);
  return found;
}

} // namespace ionskin
