// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/text/csv_file.hpp"

#include <string>
#include <vector>

namespace ionskin {

/// A column of a recording. What a stamp of an epoch in nanoseconds says within a second is lost in
/// a double, so that values are kept as distances from the first one.
struct NumberColumn {
  CsvTitle title;
  bool numbers = true;             ///< false where a cell is neither a number nor empty
  double first = 0;                ///< the first value that is there
  std::vector<double> since_first; ///< one entry per row; not a number where the cell is empty
  std::string text;                ///< the first cell that is neither a number nor empty
  std::size_t text_line = 0;       ///< where it stands, from 1; 0 without one
};

/// Reads a table of any columns, as robots record it: what `CsvFile` reads, with a header that may
/// begin with # (EuRoC) or % (rostopic). Cells such as "nan" count as empty; a column without
/// numbers, or without a name, is there with `numbers` false.
/// Throws UserError with the line where a row has more or fewer cells than the header, and where
/// there is no header or no row.
std::vector<NumberColumn> read_number_table(const std::string& path, const std::string& kind);

} // namespace ionskin
