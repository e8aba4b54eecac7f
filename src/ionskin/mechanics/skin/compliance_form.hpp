// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/mechanics/surface/contact_cells.hpp"

namespace ionskin::mechanics {

/// True if the compliance of the cells is evaluated as products instead of a matrix. Products serve
/// where the matrix would be large. They need equally large cells and a contact without adhesion,
/// whose stability only a factorised matrix shows.
bool takes_products(const Case& input, const ContactCells& cells);

} // namespace ionskin::mechanics
