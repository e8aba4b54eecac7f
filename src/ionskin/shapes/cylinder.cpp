// SPDX-License-Identifier: Apache-2.0
#include "ionskin/shapes/cylinder.hpp"

#include <cmath>

namespace ionskin::shapes {

double Cylinder::height(const Plan&, double x, double) const {
  return arc_height(radius, std::abs(x));
}

std::array<double, 2> Cylinder::flat_half_size(const Plan& plan) const {
  return {0, plan.size[1] / 2};
}

double Cylinder::border(const Plan&, const Pressing& pressing, std::size_t) const {
  return line_contact(radius, pressing);
}

std::vector<Misfit> Cylinder::misfits(const Plan& plan) const {
  return longer_than_diameter(radius, plan, 1);
}

} // namespace ionskin::shapes
