// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/text/csv_file.hpp"

#include "ionskin/base/files/read_text_file.hpp"
#include "ionskin/base/text.hpp"

#include <algorithm>

namespace ionskin {

CsvFile::CsvFile(const std::string& path, const std::string& kind)
    : stream_(base::read_text_file(path, kind)) {}

std::optional<CsvRow> CsvFile::next() {
  for (std::string line; std::getline(stream_, line);) {
    ++line_;
    const std::string text = base::trimmed(line, base::csv_blanks);
    if (!text.empty() && text.front() != '#')
      return CsvRow{line, base::split(line, ',', base::csv_blanks)};
  }
  line_ = std::max<std::size_t>(line_, 1);
  return std::nullopt;
}

CsvTitle csv_title(const std::string& cell) {
  const auto open = cell.find('['), close = cell.find(']');
  if (open == std::string::npos || close == std::string::npos || close < open)
    return {cell, std::nullopt};
  return {base::trimmed(cell.substr(0, open), base::csv_blanks),
          base::trimmed(cell.substr(open + 1, close - open - 1), base::csv_blanks)};
}

} // namespace ionskin
