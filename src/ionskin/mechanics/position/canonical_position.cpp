// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/position/canonical_position.hpp"

#include <cmath>

namespace ionskin::mechanics {
namespace {

std::size_t reflected_cell(const ContactCells& cells, std::size_t cell,
                           const std::array<bool, 2>& reflect) {
  const std::size_t nx = cells.columns(), ny = cells.rows(), i = cell % nx, j = cell / nx;
  return (reflect[0] ? nx - 1 - i : i) + nx * (reflect[1] ? ny - 1 - j : j);
}

} // namespace

CanonicalPosition canonical_position(const Skin& skin, const std::array<double, 2>& centre) {
  CanonicalPosition result;
  const std::array<double, 2> size{skin.length, skin.width};
  for (std::size_t d = 0; d < 2; ++d) {
    // A centre on the symmetry line stays unreflected whatever the rounding.
    result.reflect[d] = centre[d] > size[d] / 2 * (1 + 1e-12);
    result.centre[d] = result.reflect[d] ? size[d] - centre[d] : centre[d];
  }
  return result;
}

bool same_place(const Skin& skin, const std::array<double, 2>& a, const std::array<double, 2>& b) {
  return std::abs(a[0] - b[0]) <= 1e-10 * skin.length &&
         std::abs(a[1] - b[1]) <= 1e-10 * skin.width;
}

CellVector reflected(const ContactCells& cells, const CellVector& vector,
                     const std::array<bool, 2>& reflect) {
  CellVector result(vector.size());
  for (std::size_t cell = 0; cell < cells.count(); ++cell) {
    const std::size_t from = 3 * reflected_cell(cells, cell, reflect), to = 3 * cell;
    result[to] = vector[from];
    result[to + 1] = reflect[0] ? -vector[from + 1] : vector[from + 1];
    result[to + 2] = reflect[1] ? -vector[from + 2] : vector[from + 2];
  }
  return result;
}

} // namespace ionskin::mechanics
