// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/skin/compliance_form.hpp"

#include "ionskin/finite_layers/plane/cell_convolution.hpp"
#include "ionskin/laws/friction/friction_law.hpp"

namespace ionskin::mechanics {

bool takes_products(const Case& input, const ContactCells& cells) {
  constexpr std::size_t most_of_matrix = 1500; // cells
  return cells.count() > most_of_matrix && finite_layers::is_even({cells.lines_x, cells.lines_y}) &&
         !laws::friction_law(input.contact.law).adheres;
}

} // namespace ionskin::mechanics
