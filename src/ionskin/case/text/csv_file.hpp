// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

namespace ionskin {

/// A row of a CSV file.
struct CsvRow {
  std::string text;               ///< the whole line
  std::vector<std::string> cells; ///< without the blanks and quotes around them
};

/// A user's CSV file, row by row; empty lines and lines that begin with # are passed over.
class CsvFile {
public:
  /// @param kind what the file is in messages, such as "waypoint"
  /// Throws UserError as `read_text_file` does.
  CsvFile(const std::string& path, const std::string& kind);

  /// The next row; nothing at the end of the file.
  std::optional<CsvRow> next();
  /// Of the row read last, from 1; at the end of the file its last line.
  std::size_t line() const { return line_; }

private:
  std::istringstream stream_;
  std::size_t line_ = 0;
};

/// A cell of a header: "time [ms]".
struct CsvTitle {
  std::string name;
  std::optional<std::string> unit;
};

CsvTitle csv_title(const std::string& cell);

} // namespace ionskin
