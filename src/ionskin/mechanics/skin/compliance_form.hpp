// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/mechanics/surface/contact_cells.hpp"

namespace ionskin::mechanics {

/// The one choice between the matrix of the compliance and products without it: products where the
/// matrix would be large. They ask for even cells; and whether an adhesive contact can last is seen
/// by the factors of a matrix alone.
bool takes_products(const Case& input, const ContactCells& cells);

} // namespace ionskin::mechanics
