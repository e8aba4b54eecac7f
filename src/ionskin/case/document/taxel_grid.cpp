// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/document/taxel_grid.hpp"

#include <fmt/format.h>

namespace ionskin {

std::array<double, 2> taxel_size(const TaxelGrid& grid, const Skin& skin) {
  return {(skin.length - (grid.columns - 1) * grid.gap) / grid.columns,
          (skin.width - (grid.rows - 1) * grid.gap) / grid.rows};
}

std::vector<Taxel> taxels_of(const TaxelGrid& grid, const Skin& skin) {
  std::vector<Taxel> taxels;
  if (grid.rows < 1 || grid.columns < 1) {
    return taxels;
  }
  const std::array<double, 2> size = taxel_size(grid, skin);
  if (size[0] <= 0 || size[1] <= 0) {
    return taxels;
  }
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      const std::array<double, 2> lower{column * (size[0] + grid.gap), row * (size[1] + grid.gap)};
      taxels.push_back({fmt::format("r{}c{}", row + 1, column + 1),
                        lower,
                        {lower[0] + size[0], lower[1] + size[1]}});
    }
  }
  return taxels;
}

} // namespace ionskin
