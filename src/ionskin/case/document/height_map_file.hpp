// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/shapes/height_map.hpp"

#include <string>

namespace ionskin {

/// Reads a comma-separated table: its corner names the unit of length of all numbers, the first row
/// goes on with x, each further row holds y and the heights along x. Throws UserError.
shapes::HeightMap read_height_map(const std::string& path);

} // namespace ionskin
