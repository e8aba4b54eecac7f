// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"

#include <array>
#include <vector>

namespace ionskin {

/// Size of one taxel of a grid over the whole top face, along x and y; not above 0 where the gaps
/// leave no room [m].
std::array<double, 2> taxel_size(const TaxelGrid& grid, const Skin& skin);

/// The taxels of a grid, row by row: "r1c1" has the least x and y, columns follow x and rows y.
/// Empty without a grid, or where the gaps leave no room.
std::vector<Taxel> taxels_of(const TaxelGrid& grid, const Skin& skin);

} // namespace ionskin
