// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/readout/signals.hpp"

#include <filesystem>
#include <string>

namespace ionskin::results {

/// The table as CSV: a header with units ("time [s]"), `cycle` and `phase` behind the first column
/// if the table has them, numbers with all their digits (reading them back gives the same doubles),
/// empty entries for NaN and for cycle 0.
std::string csv_text(const readout::SignalTable& table);
/// Writes the file atomically. Throws UserError when it cannot.
void write_csv(const std::filesystem::path& path, const readout::SignalTable& table);

} // namespace ionskin::results
