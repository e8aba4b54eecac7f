// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/shapes/round_body.hpp"

namespace ionskin::shapes {

/// A cylinder that lies on the skin with its axis along y, with a sharp edge at each end.
struct Cylinder final : Shape {
  double radius = 0; ///< [m]

  static constexpr std::string_view meaning = "a cylinder with its axis along y";
  static constexpr auto parameters() {
    return std::array{laws::OwnParameter<Cylinder>{body_radius, &Cylinder::radius}};
  }
  double height(const Plan& plan, double x, double y) const override;
  std::array<double, 2> flat_half_size(const Plan& plan) const override;
  double border(const Plan& plan, const Pressing& pressing, std::size_t direction) const override;
  std::vector<Misfit> misfits(const Plan& plan) const override;
};

} // namespace ionskin::shapes
