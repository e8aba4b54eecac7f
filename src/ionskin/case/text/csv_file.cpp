// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/text/csv_file.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/base/files/read_text_file.hpp"
#include "ionskin/base/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

namespace ionskin {
namespace {

constexpr std::string_view utf8_mark = "\xEF\xBB\xBF";
constexpr std::string_view line_ends = "\r\n";
constexpr std::string_view digits = "0123456789";

bool is_digit(char letter) {
  return digits.find(letter) != digits.npos;
}

std::string_view without_mark(std::string_view text) {
  return text.starts_with(utf8_mark) ? text.substr(utf8_mark.size()) : text;
}

/// Offset of the first byte after the line end (LF, CRLF or CR) at the offset `at`.
std::size_t behind_line_end(std::string_view text, std::size_t at) {
  return at + (text.substr(at, 2) == "\r\n" ? 2 : 1);
}

/// True if a cell consists of digits with dots or commas, and perhaps a sign and an exponent.
bool looks_like_number(std::string_view text) {
  if (text.starts_with('-') || text.starts_with('+'))
    text.remove_prefix(1);
  const std::size_t mantissa = std::min(text.find_first_not_of("0123456789.,"), text.size());
  if (text.substr(0, mantissa).find_first_of(digits) == text.npos)
    return false;
  text.remove_prefix(mantissa);
  if (!text.empty() && (text.front() == 'e' || text.front() == 'E')) {
    text.remove_prefix(1);
    if (text.starts_with('-') || text.starts_with('+'))
      text.remove_prefix(1);
    return !text.empty() && text.find_first_not_of(digits) == text.npos;
  }
  return text.empty();
}

/// True for "1,234": one to three digits, the first not 0, before a comma, and three behind it.
bool may_group_thousands(std::string_view number) {
  const std::size_t first = std::min(number.find_first_of(digits), number.size());
  const std::size_t comma = number.find(',');
  const std::size_t end = std::min(number.find_first_not_of(digits, comma + 1), number.size());
  return comma - first >= 1 && comma - first <= 3 && number[first] != '0' && end - comma == 4;
}

bool commas_are_decimal(std::string_view line) {
  for (std::size_t i = line.find(','); i != line.npos; i = line.find(',', i + 1))
    if (i == 0 || i + 1 == line.size() || !is_digit(line[i - 1]) || !is_digit(line[i + 1]))
      return false;
  return true;
}

} // namespace

CsvFile::CsvFile(const std::string& path, const std::string& kind)
    : path_(path), text_(base::read_text_file(path, kind)) {
  // Every second byte of ASCII characters in UTF-16 is 0; text in UTF-8 has no such byte.
  if (text_.starts_with("\xFF\xFE") || text_.starts_with("\xFE\xFF") ||
      text_.find('\0') != text_.npos)
    throw UserError(fmt::format(
        "the {} file {} is UTF-16, or not text\n  = save it as CSV in UTF-8, or convert it: iconv "
        "-f UTF-16 -t UTF-8 FILE > NEW",
        kind, base::shown(path)));
  at_ = text_.size() - without_mark(text_).size();
}

void CsvFile::refuse(const std::string& problem, const std::string& remedy) const {
  throw UserError(
      fmt::format("{}\n --> {}:{}\n  = {}", problem, base::shown(path_), line_, remedy));
}

std::optional<std::vector<std::string>> CsvFile::next() {
  while (at_ < text_.size()) {
    line_ = next_line_;
    if (text_[at_] == '#' || text_.compare(at_, 2, "\"#") == 0) {
      comment_ = at_;
      at_ = std::min(text_.find_first_of(line_ends, at_), text_.size());
      end_line();
      continue;
    }
    if (separator_ == 0)
      find_separator();
    std::vector<std::string> cells = record();
    const bool blank =
        std::ranges::all_of(cells, [](const std::string& one) { return one.empty(); });
    if (blank || cells.front().starts_with('#'))
      continue;
    for (std::string& one : cells)
      take_decimal_comma(one);
    return cells;
  }
  line_ = std::max<std::size_t>(line_, 1);
  return std::nullopt;
}

std::vector<std::string> CsvFile::cells_of_comment() {
  if (!comment_)
    return {};
  const std::size_t at = std::exchange(at_, *comment_), next_line = next_line_;
  std::vector<std::string> cells = record();
  at_ = at;
  next_line_ = next_line;
  return cells;
}

bool CsvFile::at_end_of_line() const {
  return at_ == text_.size() || line_ends.find(text_[at_]) != line_ends.npos;
}

void CsvFile::end_line() {
  if (at_ < text_.size()) {
    at_ = behind_line_end(text_, at_);
    ++next_line_;
  }
}

/// Detects the separator from the first row that is not empty, or from Excel's "sep=;".
void CsvFile::find_separator() {
  const std::size_t end = std::min(text_.find_first_of(line_ends, at_), text_.size());
  const std::string line = base::trimmed(std::string_view(text_).substr(at_, end - at_));
  if (line.empty())
    return;
  if (line.starts_with("sep=") && line.size() == 5) { // written by Excel
    separator_ = line[4];
    at_ = end;
    end_line();
    line_ = next_line_;
    return;
  }
  if (line.find_first_of(",;\t") == line.npos && line.find_first_of("| ") != line.npos) {
    const char* const other = line.find('|') == line.npos ? " " : "|";
    refuse("the first row has neither a comma nor a semicolon nor a tab between columns",
           fmt::format("put one there, such as by: tr -s '{}' ',' < FILE > NEW", other));
  }
  separator_ = ',';
  for (const char other : {'\t', ';'})
    if (line.find(other) != line.npos && commas_are_decimal(line))
      separator_ = other;
}

std::vector<std::string> CsvFile::record() {
  std::vector<std::string> cells{cell()};
  while (at_ < text_.size() && text_[at_] == separator_) {
    ++at_;
    cells.push_back(cell());
  }
  end_line();
  return cells;
}

std::string CsvFile::cell() {
  while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t') &&
         text_[at_] != separator_)
    ++at_;
  if (at_ < text_.size() && text_[at_] == '"')
    return quoted();
  const std::size_t begin = at_;
  while (!at_end_of_line() && text_[at_] != separator_)
    ++at_;
  return base::trimmed(std::string_view(text_).substr(begin, at_ - begin));
}

/// Reads a quoted cell; the opening quote is at the offset `at_`.
std::string CsvFile::quoted() {
  std::string content;
  for (++at_;; ++at_) {
    if (at_ == text_.size())
      refuse("a quote that opens in this row never closes",
             "close it, or double a quote that belongs to the text");
    if (text_[at_] == '"') {
      if (text_.compare(at_, 2, "\"\"") != 0)
        break;
      ++at_;
    }
    // A line end CRLF is counted at its LF.
    if (text_[at_] == '\n' || (text_[at_] == '\r' && text_.compare(at_, 2, "\r\n") != 0))
      ++next_line_;
    content += text_[at_];
  }
  const std::size_t begin = ++at_;
  while (!at_end_of_line() && text_[at_] != separator_)
    ++at_;
  const std::string behind = base::trimmed(std::string_view(text_).substr(begin, at_ - begin));
  // Text behind the quotes belongs to the cell: a quoted name with its unit, "\"x\" [mm]".
  return base::trimmed(content) + (behind.empty() ? "" : " " + behind);
}

void CsvFile::take_decimal_comma(std::string& cell) {
  if (!looks_like_number(cell))
    return;
  const auto commas = std::ranges::count(cell, ','), points = std::ranges::count(cell, '.');
  constexpr const char* remedy = "write decimal points, and thousands without marks between them";
  if (commas + points != 1) // nothing to decide, or not a number, which the caller refuses
    return;
  if (commas == 1 && separator_ != ';' && may_group_thousands(cell))
    refuse(fmt::format("\"{}\" may be a number of thousands or one with a decimal comma",
                       base::shown(cell)),
           remedy);
  if (commas == 1 && comma_line_ == 0)
    comma_line_ = line_;
  if (points == 1 && point_line_ == 0)
    point_line_ = line_;
  if (comma_line_ > 0 && point_line_ > 0)
    refuse(fmt::format("decimal commas and decimal points stand in one file, in lines {} and {}",
                       comma_line_, point_line_),
           remedy);
  std::ranges::replace(cell, ',', '.');
}

CsvTitle csv_title(const std::string& cell) {
  const bool square = cell.find('[') != cell.npos;
  const auto open = cell.find(square ? '[' : '('), close = cell.rfind(square ? ']' : ')');
  const bool has_unit = open != cell.npos && close != cell.npos && close > open &&
                        (square || close + 1 == cell.size());
  std::string name = base::trimmed(std::string_view(cell).substr(0, has_unit ? open : cell.size()));
  for (char& letter : name)
    if (letter >= 'A' && letter <= 'Z')
      letter = static_cast<char>(letter - 'A' + 'a');
  if (!has_unit)
    return {name, std::nullopt};
  return {name, base::trimmed(std::string_view(cell).substr(open + 1, close - open - 1))};
}

std::string csv_line(const std::string& text, std::size_t number) {
  std::string_view rest = without_mark(text);
  for (std::size_t i = 1; i < number && !rest.empty(); ++i) {
    const std::size_t end = std::min(rest.find_first_of(line_ends), rest.size());
    rest.remove_prefix(end == rest.size() ? end : behind_line_end(rest, end));
  }
  return std::string(rest.substr(0, rest.find_first_of(line_ends)));
}

} // namespace ionskin
