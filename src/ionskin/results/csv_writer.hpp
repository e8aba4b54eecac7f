// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/readout/signals.hpp"

#include <filesystem>
#include <string>

namespace ionskin::results {

/// Formats a table of signals as CSV text. The header gives names with units ("time [s]"); columns
/// `cycle` and `phase` follow the first column if the table has them. Numbers have as many digits
/// as it takes to read back the identical doubles; NaN and cycle 0 become empty entries.
std::string csv_text(const readout::SignalTable& table);
/// Writes `csv_text` of a table to a file, atomically. Throws UserError when the file cannot be
/// written.
void write_csv(const std::filesystem::path& path, const readout::SignalTable& table);

} // namespace ionskin::results
