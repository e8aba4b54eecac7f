// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/shapes/height_map.hpp"

#include <string>

namespace ionskin {

/// Reads a height map from a CSV file. The first cell names the unit of length of all numbers. The
/// rest of the first row holds the x of the grid lines; each further row holds y and the heights
/// along x. Returned in metres. Throws UserError with the line when the file is no such table, or x
/// or y do not ascend.
shapes::HeightMap read_height_map(const std::string& path);

} // namespace ionskin
