// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

namespace ionskin::apps::studio {

/// Reads a CSV table of a run as a packed message, see `packed`: the heading {"rows", "columns":
/// [{"name", "unit", "texts"}]} and the columns of numbers one after another as 64-bit floats, NaN
/// for an empty cell. A column of words has its cells in "texts" and no numbers.
/// Throws HttpError 413 when the file, a row, or the number of columns or cells is too large.
std::string packed_table(const std::filesystem::path& path);

} // namespace ionskin::apps::studio
