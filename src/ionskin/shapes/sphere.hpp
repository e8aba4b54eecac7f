// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/shapes/round_body.hpp"

namespace ionskin::shapes {

/// A sphere, or the part of it that the plan cuts out around its lowest point.
struct Sphere final : Shape {
  double radius = 0; ///< [m]

  static constexpr std::string_view meaning = "a sphere";
  static constexpr bool has_whole_plan = true;
  static constexpr auto parameters() {
    return std::array{laws::OwnParameter<Sphere>{body_radius, &Sphere::radius}};
  }
  double height(const Plan& plan, double x, double y) const override;
  /// Upper bound of the radius of the contact [m]: that of Hertz on a half-space under a force, or
  /// that on a thin bonded incompressible layer under an indentation, whichever is larger.
  double border(const Plan& plan, const Pressing& pressing, std::size_t direction) const override;
  bool turns_into_itself(const Plan& plan) const override;
  std::optional<std::array<double, 2>> whole_plan() const override;
  std::vector<Misfit> misfits(const Plan& plan) const override;
};

} // namespace ionskin::shapes
