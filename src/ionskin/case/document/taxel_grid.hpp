// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"

#include <array>
#include <vector>

namespace ionskin {

/// Size along x and y of one taxel of a grid over the whole top face [m]; 0 or negative if the gaps
/// leave no room. The grid must have rows and columns.
std::array<double, 2> taxel_size(const TaxelGrid& grid, const Skin& skin);

/// Makes the taxels of a grid, row by row, columns along x and rows along y; "r1c1" has the least x
/// and y. Empty without a grid, or if the gaps leave no room.
std::vector<Taxel> taxels_of(const TaxelGrid& grid, const Skin& skin);

} // namespace ionskin
