// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace ionskin {

/// A user's CSV file by the rules of RFC 4180, row by row, as spreadsheets, instruments and pandas
/// leave it: a byte order mark of UTF-8; lines that end in LF, CRLF or CR; quoted cells, with
/// doubled quotes and line ends in them; columns between commas, semicolons or tabs, as the first
/// row (or Excel's "sep=;") tells; decimal commas where they can be nothing else, given as points.
/// Rows whose cells are all empty, and rows that begin with #, are passed over.
class CsvFile {
public:
  /// @param kind what the file is in messages, such as "waypoint"
  /// Throws UserError as `read_text_file` does, and for UTF-16.
  CsvFile(const std::string& path, const std::string& kind);

  /// The cells of the next row, without the blanks around them; nothing at the end of the file.
  /// Throws UserError with the line for quotes that do not close, for numbers whose commas may as
  /// well group thousands, and for a first row of columns that something else separates.
  std::optional<std::vector<std::string>> next();
  /// The cells of the last row that begins with # and was passed over, by the separators of the
  /// others: some programs begin their header so. Empty where there is none.
  std::vector<std::string> cells_of_comment();
  /// On which the row read last begins, from 1; at the end of the file its last line.
  std::size_t line() const { return line_; }

  /// Throws UserError that points at the line.
  [[noreturn]] void refuse(const std::string& problem, const std::string& remedy) const;

private:
  std::vector<std::string> record();
  std::string cell();
  std::string quoted();
  bool at_end_of_line() const;
  void end_line();
  void find_separator();
  void take_decimal_comma(std::string& cell);

  std::string path_, text_;
  std::size_t at_ = 0, line_ = 0, next_line_ = 1;
  std::optional<std::size_t> comment_; ///< place where the last one begins
  char separator_ = 0;
  std::size_t comma_line_ = 0, point_line_ = 0; ///< of the first such decimal; 0 for none
};

/// A cell of a header: "time [ms]", or "Time (ms)" as instruments write it.
struct CsvTitle {
  std::string name; ///< in small letters
  std::optional<std::string> unit;
};

CsvTitle csv_title(const std::string& cell);

/// A line of a text, from 1, whatever ends it; without a byte order mark.
std::string csv_line(const std::string& text, std::size_t number);

} // namespace ionskin
