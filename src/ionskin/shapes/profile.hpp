// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/shapes/shape.hpp"

namespace ionskin::shapes {

/// An underside of any form, given by the height map of its plan.
struct Profile final : Shape {
  static constexpr std::string_view meaning = "a map of heights";
  static constexpr bool takes_heights = true;
  static constexpr auto parameters() { return laws::no_parameters<Profile>; }

  double height(const Plan& plan, double x, double y) const override;
  double lowest(const Plan& plan) const override;
  double lowest_on_slope(const Plan& plan, const std::array<double, 2>& slope) const override;
  std::array<bool, 2> symmetric(const Plan& plan) const override;
  /// Largest distance from the centre, along `direction`, at which the undeformed skin overlaps the
  /// height map at this indentation [m]; infinity under a force.
  double border(const Plan& plan, const Pressing& pressing, std::size_t direction) const override;
  std::vector<Misfit> misfits(const Plan& plan) const override;
};

} // namespace ionskin::shapes
