// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/text/csv_table.hpp"

#include "ionskin/base/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <string_view>

namespace ionskin {
namespace {

/// True if a column has a name. "Unnamed: 0" counts as none: pandas writes it for an index without
/// one.
bool is_name(std::string_view title) {
  return !title.empty() && !title.starts_with("Unnamed: ");
}

std::optional<long long> whole_number(std::string_view text) {
  long long number = 0;
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool whole = status == std::errc() && end == text.data() + text.size();
  return whole ? std::optional(number) : std::nullopt;
}

} // namespace

CsvTable::CsvTable(const std::string& path, const std::string& kind) : file_(path, kind) {
  for (const std::string& cell : file_.next().value_or(std::vector<std::string>())) {
    named_.push_back(is_name(cell));
    if (named_.back())
      titles_.push_back(csv_title(cell));
  }
}

std::optional<std::vector<std::string>> CsvTable::next() {
  std::optional<std::vector<std::string>> row = file_.next();
  if (!row)
    return std::nullopt;
  const std::size_t width = row->size();
  row->resize(std::max(width, named_.size()));
  std::vector<std::string> cells;
  for (std::size_t i = 0; i < row->size(); ++i) {
    const bool named = i < named_.size() && named_[i];
    const bool missing = named && i >= width;
    if (missing || (i >= named_.size() && !(*row)[i].empty()))
      refuse(fmt::format("{} entries under {} columns", width, titles_.size()),
             "give every line one entry a column; an empty one is nothing between separators");
    if (named)
      cells.push_back((*row)[i]);
    else
      pass_over(i, (*row)[i]);
  }
  return cells;
}

void CsvTable::pass_over(std::size_t column, const std::string& cell) {
  if (cell.empty())
    return;
  const std::optional<long long> number = whole_number(cell);
  if (column == 0 && number && (!counted_ || *number > *counted_)) {
    counted_ = number;
    return;
  }
  refuse(fmt::format("column {} has no name, and holds \"{}\"", column + 1, base::shown(cell)),
         "name it and its unit in the first row, such as \"time [s]\", or remove the column");
}

} // namespace ionskin
