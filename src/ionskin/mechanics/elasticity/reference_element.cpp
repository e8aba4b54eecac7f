// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/elasticity/reference_element.hpp"

namespace ionskin::mechanics {
namespace {

using Integrals = std::array<std::array<double, 3>, 3>;

// Integrals of products of the quadratic Lagrange basis on [0, 1] with nodes 0, 1/2, 1:
// of values, of slope (row) and value (column), of slopes.
constexpr Integrals value_value{{{4.0 / 30, 2.0 / 30, -1.0 / 30},
                                 {2.0 / 30, 16.0 / 30, 2.0 / 30},
                                 {-1.0 / 30, 2.0 / 30, 4.0 / 30}}};
constexpr Integrals slope_value{
    {{-3.0 / 6, -4.0 / 6, 1.0 / 6}, {4.0 / 6, 0.0, -4.0 / 6}, {-1.0 / 6, 4.0 / 6, 3.0 / 6}}};
constexpr Integrals slope_slope{
    {{7.0 / 3, -8.0 / 3, 1.0 / 3}, {-8.0 / 3, 16.0 / 3, -8.0 / 3}, {1.0 / 3, -8.0 / 3, 7.0 / 3}}};

/// Of two nodes of a line, along an axis that one, both or neither function is derived along.
double line_integral(bool slope_i, bool slope_j, int i, int j) {
  if (slope_i && slope_j) {
    return slope_slope[i][j];
  }
  return slope_i ? slope_value[i][j] : slope_j ? slope_value[j][i] : value_value[i][j];
}

ReferenceElement build() {
  ReferenceElement result;
  for (int r = 0; r < 3; ++r) {
    for (int s = 0; s < 3; ++s) {
      for (int i = 0; i < element_nodes; ++i) {
        for (int j = 0; j < element_nodes; ++j) {
          result.gradient_product[r][s][i][j] =
              line_integral(r == 0, s == 0, i % 3, j % 3) *
              line_integral(r == 1, s == 1, i / 3 % 3, j / 3 % 3) *
              line_integral(r == 2, s == 2, i / 9, j / 9);
        }
      }
    }
  }
  return result;
}

} // namespace

const ReferenceElement& reference_element() {
  static const ReferenceElement element = build();
  return element;
}

} // namespace ionskin::mechanics
