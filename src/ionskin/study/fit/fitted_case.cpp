// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/fit/fitted_case.hpp"

#include "ionskin/base/text.hpp"
#include "ionskin/case/reading/read_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <sstream>

namespace ionskin::study {
namespace {

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) {
    lines.push_back(line);
  }
  return lines;
}

/// The line without its comment: without everything from a # outside of TOML strings.
std::string without_comment(const std::string& line) {
  char quote = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (quote == '"' && line[i] == '\\') {
      ++i;
    } else if (quote != 0) {
      quote = line[i] == quote ? 0 : quote;
    } else if (line[i] == '"' || line[i] == '\'') {
      quote = line[i];
    } else if (line[i] == '#') {
      return line.substr(0, line.find_last_not_of(" \t", i - (i > 0 ? 1 : 0)) + 1);
    }
  }
  return line;
}

bool is_comment(const std::string& line) {
  return base::trimmed(line).starts_with('#');
}

} // namespace

std::string fitted_case_text(const FitModel& model, const std::vector<double>& values,
                             const std::string& data) {
  const std::string text = model.case_at(values).text;
  const CaseDocument document = read_case_text(text, model.path());
  std::vector<std::string> lines = lines_of(text);
  std::set<std::size_t> left_out;
  std::string keys;
  for (const FitParameter& parameter : model.parameters()) {
    if (is_data_key(parameter.key)) {
      continue;
    }
    keys += (keys.empty() ? "" : ", ") + parameter.key;
    const ValueRecord* record = document.find(parameter.key);
    if (record == nullptr || !record->place || record->place->line == 0) {
      continue;
    }
    std::size_t line = record->place->line - 1;
    lines[line] = without_comment(lines[line]);
    while (line > 0 && is_comment(lines[line - 1])) {
      left_out.insert(--line);
    }
  }
  std::string name = data; // a file's name may hold a line end, which would end the comment
  std::ranges::replace_if(
      name, [](unsigned char letter) { return letter < ' '; }, '?');
  std::string result = keys.empty() ? "" : fmt::format("# Fitted to {}: {}\n", name, keys);
  for (std::size_t line = 0; line < lines.size(); ++line) {
    result += left_out.contains(line) ? "" : lines[line] + "\n";
  }
  return result;
}

} // namespace ionskin::study
