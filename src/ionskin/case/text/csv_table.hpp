// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/text/csv_file.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace ionskin {

/// A CSV file with names in its first row. Columns without a name are left out where they are empty
/// (a separator at the end of the lines) or count the rows (the index of pandas), and refused
/// elsewhere.
class CsvTable {
public:
  /// Throws as `CsvFile` does. @param kind what the file is in messages
  CsvTable(const std::string& path, const std::string& kind);

  /// Titles of the columns with a name, in their order; empty where the file has no row.
  const std::vector<CsvTitle>& titles() const { return titles_; }

  /// The cells below `titles` of the next row; nothing at the end of the file. Throws UserError
  /// with the line where a row has more or fewer cells than the header has.
  std::optional<std::vector<std::string>> next();

  std::size_t line() const { return file_.line(); }
  [[noreturn]] void refuse(const std::string& problem, const std::string& remedy) const {
    file_.refuse(problem, remedy);
  }

private:
  void pass_over(std::size_t column, const std::string& cell);

  CsvFile file_;
  std::vector<CsvTitle> titles_;
  std::vector<bool> named_; ///< per column of the file
  std::optional<long long> counted_;
};

} // namespace ionskin
