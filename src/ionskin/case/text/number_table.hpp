// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/text/csv_file.hpp"

#include <string>
#include <vector>

namespace ionskin {

/// One column of a recording, in the unit of its title. Values are stored as differences from the
/// first one, because a double cannot resolve time stamps that count nanoseconds of an epoch.
struct NumberColumn {
  CsvTitle title;
  bool numbers = true; ///< true if all cells are numbers or empty, and not all empty
  double first = 0;    ///< first number of the column; 0 without one
  std::vector<double>
      since_first;           ///< if `numbers`: value minus `first`, [row]; NaN for an empty cell
  std::string text;          ///< first cell that is neither a number nor empty
  std::size_t text_line = 0; ///< line of `text` in the file, from 1; 0 without one
};

/// Reads a CSV file of any columns, as robots record it, by the rules of `CsvFile`. The header may
/// begin with # (EuRoC) or % (rostopic). Cells such as "nan" count as empty. A column without
/// numbers or without a name is returned with `numbers` false.
/// @param kind kind of the file, for messages
/// Throws UserError as `CsvFile` does, and with the line when a row has more or fewer cells than
/// the header, or when the file has no header or no row.
std::vector<NumberColumn> read_number_table(const std::string& path, const std::string& kind);

} // namespace ionskin
