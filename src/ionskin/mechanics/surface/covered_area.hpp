// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/mechanics/surface/contact_cells.hpp"
#include "ionskin/mechanics/surface/contact_problem.hpp"

#include <vector>

namespace ionskin::mechanics {

/// Area in which a cell field is positive that falls to zero at the area's border like the square
/// root of the distance, as contact pressure does. The positive cells count whole; at each of their
/// faces towards an open cell the border is found from the square root through the means of the
/// last two cells. Straight borders are found within 0.15 of a cell.
/// @param field [cells]; exactly 0 outside the area
double covered_area(const ContactCells& cells, const std::vector<double>& field);

/// Area by which the border of the positive cells is in doubt where the field need not fall to zero
/// as above: half of the row of cells on either side of it, the larger one. Faces at the border of
/// the cells themselves are none of it.
/// @param field [cells]
double border_area(const ContactCells& cells, const std::vector<double>& field);

/// Normal force of each cell over its area, at least 0 [Pa].
std::vector<double> normal_pressure(const ContactCells& cells, const CellVector& force);

/// Area of the contact, from the normal forces [m2].
double contact_area(const ContactCells& cells, const CellVector& force);

} // namespace ionskin::mechanics
