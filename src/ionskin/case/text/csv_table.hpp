// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/text/csv_file.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace ionskin {

/// Reads a CSV file whose first row holds the names of the columns. A column without a name is
/// skipped if it is empty (a separator ends each line) or counts the rows (the index of pandas),
/// and refused otherwise.
class CsvTable {
public:
  /// Reads the header.
  /// @param kind kind of the file, for messages: "waypoint"
  /// Throws UserError as `CsvFile` and `CsvFile::next` do.
  CsvTable(const std::string& path, const std::string& kind);

  /// Titles of the columns that have a name, in their order; empty if the file has no row.
  const std::vector<CsvTitle>& titles() const { return titles_; }

  /// Reads the next row and returns one cell for each entry of `titles`; empty at the end of the
  /// file. Throws UserError with the line as `CsvFile::next` does, when the row has more or fewer
  /// cells than the header, and when a column without a name holds anything but row numbers.
  std::optional<std::vector<std::string>> next();

  std::size_t line() const { return file_.line(); } ///< line of the row read last, from 1
  /// Throws UserError that names the file and `line()`.
  [[noreturn]] void refuse(const std::string& problem, const std::string& remedy) const {
    file_.refuse(problem, remedy);
  }

private:
  /// Skips a cell of a column without a name, or throws UserError.
  void pass_over(std::size_t column, const std::string& cell);

  CsvFile file_;
  std::vector<CsvTitle> titles_;
  std::vector<bool> named_;          ///< true for columns that have a name, [column of the file]
  std::optional<long long> counted_; ///< last row number in a first column without a name
};

} // namespace ionskin
