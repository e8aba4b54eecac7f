// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

namespace ionskin::mechanics {

inline constexpr int element_nodes = 27; ///< of the triquadratic hexahedron

/// Integrals of the triquadratic Lagrange basis on the unit cube, products of those on a line.
/// Nodes are in lexicographic order, x fastest. Because all elements are boxes, everything else is
/// a scaled combination of these.
struct ReferenceElement {
  /// gradient_product[r][s][i][j]: integral of dN_i/dx_r dN_j/dx_s, exact.
  std::array<std::array<std::array<std::array<double, element_nodes>, element_nodes>, 3>, 3>
      gradient_product{};
};

/// Built once; safe to use from several threads.
const ReferenceElement& reference_element();

} // namespace ionskin::mechanics
