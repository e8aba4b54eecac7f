// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

namespace ionskin::mechanics {

/// Cells between lines, x fastest.
struct CellGrid {
  std::span<const double> lines_x, lines_y; ///< [m]
  std::span<const double> area;             ///< [m2]
};

/// Area in which a cell field is positive that falls to zero at the area's border like the square
/// root of the distance, as contact pressure does. The positive cells count whole; at each of their
/// faces towards an open cell the border is found from the square root through the means of the
/// last two cells. Straight borders are found within 0.15 of a cell.
/// Allocates nothing.
/// @param field [cells]; exactly 0 outside the area
double covered_area(const CellGrid& cells, std::span<const double> field) noexcept;

/// Area by which the border of the positive cells is in doubt where the field need not fall to zero
/// as above: half of the row of cells on either side of it, the larger one. Faces at the border of
/// the cells themselves are none of it.
/// @param field [cells]
double border_area(const CellGrid& cells, std::span<const double> field) noexcept;

/// Normal force of each cell over its area, at least 0 [Pa].
std::vector<double> normal_pressure(const CellGrid& cells, const std::vector<double>& force);

/// Area of the contact, from the normal forces [m2].
double contact_area(const CellGrid& cells, const std::vector<double>& force);

} // namespace ionskin::mechanics
