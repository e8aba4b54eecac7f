// SPDX-License-Identifier: Apache-2.0
#include "ionskin/shapes/flat.hpp"

#include "ionskin/shapes/round_body.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace ionskin::shapes {

double Flat::height(const Plan& plan, double x, double y) const {
  const std::array<double, 2> flat = flat_half_size(plan);
  const double distance =
      std::hypot(std::max(0.0, std::abs(x) - flat[0]), std::max(0.0, std::abs(y) - flat[1]));
  return distance == 0 ? 0.0 : arc_height(edge_radius, distance);
}

std::array<double, 2> Flat::flat_half_size(const Plan& plan) const {
  return {plan.size[0] / 2 - edge_radius, plan.size[1] / 2 - edge_radius};
}

double Flat::border(const Plan& plan, const Pressing& pressing, std::size_t) const {
  if (pressing.force <= 0) {
    return line_contact(edge_radius, pressing);
  }
  // The indentation under the force is at most that of a circular punch within the flat part on a
  // half-space of the same modulus (Johnson, Contact Mechanics, 1985, equation 3.36).
  const std::array<double, 2> flat = flat_half_size(plan);
  const double radius = std::max(0.0, std::min(flat[0], flat[1]));
  Pressing in_place = pressing;
  in_place.force = 0;
  in_place.indentation =
      std::max(pressing.indentation, pressing.force / (2 * radius * pressing.plane_modulus));
  return std::min(edge_radius, line_contact(edge_radius, in_place));
}

std::vector<Misfit> Flat::misfits(const Plan& plan) const {
  const double most = std::min(plan.size[0], plan.size[1]) / 2;
  if (edge_radius <= most) {
    return {};
  }
  return {{fmt::format("slider.edge_radius = {:.6g} mm is more than half the slider's smaller side",
                       edge_radius * 1e3),
           {"edge_radius", "size"},
           fmt::format("it must be at most {:.6g} mm", most * 1e3)}};
}

} // namespace ionskin::shapes
