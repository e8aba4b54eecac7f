// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace ionskin {

/// Reads a user's CSV file row by row, by the rules of RFC 4180 and as spreadsheets, instruments
/// and pandas write it: with a byte order mark of UTF-8; lines that end in LF, CRLF or CR; quoted
/// cells that contain doubled quotes and line ends; commas, semicolons or tabs between columns,
/// detected from the first row or from Excel's "sep=;"; and decimal commas, returned as points,
/// where they can have no other meaning. Rows whose cells are all empty, and rows that begin with
/// #, are skipped.
class CsvFile {
public:
  /// Reads the whole file into memory.
  /// @param kind kind of the file, for messages: "waypoint"
  /// Throws UserError as `base::read_text_file` does, and when the file is in UTF-16 or is not
  /// text.
  CsvFile(const std::string& path, const std::string& kind);

  /// Reads the cells of the next row, without the blanks around them; empty at the end of the file.
  /// Throws UserError with the line for a quote that does not close, for a number whose comma may
  /// also group thousands, for decimal commas and decimal points in one file, and for a first row
  /// whose columns are separated by blanks or bars.
  std::optional<std::vector<std::string>> next();
  /// The cells of the last row that begins with # and was skipped, split at the separator of the
  /// file: some programs mark their header this way. Empty if no such row was skipped.
  std::vector<std::string> cells_of_comment();
  /// Line, from 1, on which the row read last begins; at the end of the file its last line.
  std::size_t line() const { return line_; }

  /// Throws UserError that names the file and `line()`.
  /// @param problem the mistake
  /// @param remedy advice to the user
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
  /// Offset of the next byte to read, line of the row read last, line of `at_`.
  std::size_t at_ = 0, line_ = 0, next_line_ = 1;
  std::optional<std::size_t> comment_; ///< offset of the last skipped row that begins with #
  char separator_ = 0;                 ///< 0 until it is detected
  /// Lines of the first number with a decimal comma and with a decimal point; 0 for none.
  std::size_t comma_line_ = 0, point_line_ = 0;
};

/// Name and unit of a column, from a cell of the header: "time [ms]", or "Time (ms)" as instruments
/// write it.
struct CsvTitle {
  std::string name;                ///< in lower case
  std::optional<std::string> unit; ///< as written; empty if the cell has no brackets
};

/// Splits a cell of a header into name and unit.
CsvTitle csv_title(const std::string& cell);

/// Extracts one line of a text, without its line end (LF, CRLF or CR) and without a byte order
/// mark.
/// @param number of the line, from 1; the result is empty beyond the last line
std::string csv_line(const std::string& text, std::size_t number);

} // namespace ionskin
