// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

namespace ionskin::apps::studio {

/// A CSV file of a run as a packed message: the heading {"rows", "columns": [{"name", "unit",
/// "texts"}]} and the columns of numbers one after the other as 64-bit floats; NaN for an empty
/// cell. Columns of words stand in "texts" and have no numbers.
/// Throws HttpError 413 when the file, or a row, column or cell count of it, is too large.
std::string packed_table(const std::filesystem::path& path);

} // namespace ionskin::apps::studio
