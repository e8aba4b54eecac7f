// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/shapes/round_body.hpp"

namespace ionskin::shapes {

/// A ball, of which the plan may be a part.
struct Sphere final : Shape {
  double radius = 0; ///< [m]

  static constexpr std::string_view meaning = "a sphere";
  static constexpr bool has_whole_plan = true;
  static constexpr auto parameters() {
    return std::array{laws::OwnParameter<Sphere>{body_radius, &Sphere::radius}};
  }
  double height(const Plan& plan, double x, double y) const override;
  /// Bounded as `line_contact` is, by the radius of the contact of a sphere.
  double border(const Plan& plan, const Pressing& pressing, std::size_t direction) const override;
  bool turns_into_itself(const Plan& plan) const override;
  std::optional<std::array<double, 2>> whole_plan() const override;
  std::vector<Misfit> misfits(const Plan& plan) const override;
};

} // namespace ionskin::shapes
