// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/text/number_table.hpp"

#include "ionskin/base/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>

namespace ionskin {
namespace {

/// Parses a number with all digits of a time stamp in nanoseconds. NaN for an empty cell and for
/// numbers that are not finite; empty if the cell is not a number.
std::optional<long double> number(const std::string& cell) {
  if (cell.empty())
    return std::numeric_limits<long double>::quiet_NaN();
  long double value = 0;
  const char* const begin = cell.data() + (cell.front() == '+' ? 1 : 0);
  const char* const end = cell.data() + cell.size();
  const auto [last, status] = std::from_chars(begin, end, value);
  if (status != std::errc() || last != end)
    return std::nullopt;
  const bool finite = std::isfinite(static_cast<double>(value));
  return finite ? value : std::numeric_limits<long double>::quiet_NaN();
}

class Column {
public:
  explicit Column(const std::string& cell) {
    const std::size_t begin = cell.find_first_not_of("#% ");
    column_.title = csv_title(begin == cell.npos ? "" : cell.substr(begin));
    column_.numbers = !column_.title.name.empty();
  }

  void add(const std::string& cell, std::size_t line) {
    const std::optional<long double> value = column_.numbers ? number(cell) : std::nullopt;
    if (!value) {
      if (column_.text_line == 0) {
        column_.text = cell;
        column_.text_line = line;
      }
      column_.numbers = false;
      column_.since_first.clear();
      return;
    }
    if (!first_ && !std::isnan(*value))
      first_ = *value;
    column_.since_first.push_back(static_cast<double>(*value - first_.value_or(0)));
  }

  NumberColumn take() {
    column_.numbers = column_.numbers && first_.has_value();
    column_.first = static_cast<double>(first_.value_or(0));
    return std::move(column_);
  }

private:
  NumberColumn column_;
  std::optional<long double> first_;
};

} // namespace

std::vector<NumberColumn> read_number_table(const std::string& path, const std::string& kind) {
  CsvFile file(path, kind);
  std::optional<std::vector<std::string>> row = file.next();
  std::vector<std::string> header = file.cells_of_comment();
  if (!row)
    file.refuse("the file has no row", "give a header and one row an instant");
  const bool names = std::ranges::none_of(
      *row, [](const std::string& cell) { return !cell.empty() && number(cell); });
  if (names) {
    header = *row;
    row = file.next();
  } else if (header.size() != row->size()) {
    file.refuse("the file has no header", "begin with the names of the columns, and their units, "
                                          "such as time [s],x [mm],y [mm],force [N]");
  }
  std::vector<Column> columns(header.begin(), header.end());
  std::size_t rows = 0;
  for (; row; row = file.next(), ++rows) {
    while (row->size() > columns.size() &&
           row->back().empty()) // ignore separators at the end of lines
      row->pop_back();
    if (row->size() != columns.size())
      file.refuse(fmt::format("{} entries under {} columns", row->size(), columns.size()),
                  "give every line one entry a column; an empty one is nothing between separators");
    for (std::size_t i = 0; i < columns.size(); ++i)
      columns[i].add((*row)[i], file.line());
  }
  if (rows == 0)
    file.refuse("no row stands below the header", "give one row an instant");
  std::vector<NumberColumn> result;
  for (Column& column : columns)
    result.push_back(column.take());
  return result;
}

} // namespace ionskin
