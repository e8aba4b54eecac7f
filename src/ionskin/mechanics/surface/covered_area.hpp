// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

namespace ionskin::mechanics {

/// Contact cells as a tensor grid, numbered with x fastest. Views of data that must outlive it.
struct CellGrid {
  std::span<const double> lines_x, lines_y; ///< cell edges [m]
  std::span<const double> area;             ///< of each cell [m2]
};

/// Estimates the area in which a field is positive [m2], for a field that falls to zero at its
/// border like the square root of the distance, as contact pressure does. Positive cells count in
/// full, and at each of their faces towards an open cell the border is found from the square root
/// through the means of the last two cells. The error of straight borders is below 0.15 of a cell.
/// Allocates nothing.
/// @param field mean of the field over each cell, [cells]; exactly 0 outside the area
double covered_area(const CellGrid& cells, std::span<const double> field) noexcept;

/// Uncertainty of the area in which a field is positive, where the field need not fall to zero as
/// `covered_area` assumes [m2]: half of the larger row of cells, on either side of the border. The
/// outer border of the grid does not count.
/// @param field value of each cell, [cells]
double border_area(const CellGrid& cells, std::span<const double> field) noexcept;

/// Pressure on each cell: normal force over area, at least 0 [Pa].
/// @param force on the cells, [3 cells] [N]
std::vector<double> normal_pressure(const CellGrid& cells, const std::vector<double>& force);

/// Estimates the area of the contact from the normal forces, by `covered_area` [m2].
/// @param force on the cells, [3 cells] [N]
double contact_area(const CellGrid& cells, const std::vector<double>& force);

} // namespace ionskin::mechanics
