// SPDX-License-Identifier: Apache-2.0
#include "ionskin/shapes/round_body.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ionskin::shapes {

double arc_height(double radius, double distance) {
  if (distance > radius) {
    return unreachable_gap;
  }
  const double ratio = distance / radius;
  // std::fma rounds identically with every instruction set.
  return radius * ratio * ratio / (1 + std::sqrt(std::fma(-ratio, ratio, 1.0)));
}

double line_contact(double radius, const Pressing& pressing) {
  return std::max(std::sqrt(6 * radius * pressing.indentation),
                  std::sqrt(4 * pressing.force * radius /
                            (std::numbers::pi * pressing.length * pressing.plane_modulus)));
}

std::vector<Misfit> longer_than_diameter(double radius, const Plan& plan, std::size_t directions) {
  std::vector<Misfit> result;
  for (std::size_t d = 0; d < directions; ++d) {
    if (plan.size[d] > 2 * radius * (1 + 1e-12)) {
      result.push_back({fmt::format("the slider is {:.6g} mm long along {}, more than the diameter "
                                    "of {:.6g} mm",
                                    plan.size[d] * 1e3, d == 0 ? "x" : "y", 2e3 * radius),
                        {"size", "radius"},
                        fmt::format("it must be at most {:.6g} mm", 2e3 * radius)});
    }
  }
  return result;
}

} // namespace ionskin::shapes
