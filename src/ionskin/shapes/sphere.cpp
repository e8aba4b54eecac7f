// SPDX-License-Identifier: Apache-2.0
#include "ionskin/shapes/sphere.hpp"

#include <algorithm>
#include <cmath>

namespace ionskin::shapes {

double Sphere::height(const Plan&, double x, double y) const {
  return arc_height(radius, std::hypot(x, y));
}

double Sphere::border(const Plan&, const Pressing& pressing, std::size_t) const {
  return std::max(2 * std::sqrt(radius * pressing.indentation),
                  std::cbrt(0.75 * pressing.force * radius / pressing.plane_modulus));
}

/// True for the whole plan, although it is a square: no contact reaches its corners.
bool Sphere::turns_into_itself(const Plan& plan) const {
  return plan.size == std::array<double, 2>{2 * radius, 2 * radius};
}

std::optional<std::array<double, 2>> Sphere::whole_plan() const {
  return {{2 * radius, 2 * radius}};
}

std::vector<Misfit> Sphere::misfits(const Plan& plan) const {
  return longer_than_diameter(radius, plan, 2);
}

} // namespace ionskin::shapes
