// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/shapes/shape.hpp"

namespace ionskin::shapes {

/// A block with a flat underside. Its edges are sharp, or rounded by quarter circles along the
/// whole border of the plan, corners included.
struct Flat final : Shape {
  double edge_radius = 0; ///< [m]; 0 for sharp edges

  static constexpr std::string_view meaning = "a flat face with sharp or rounded edges";
  static constexpr auto parameters() {
    return std::array{laws::OwnParameter<Flat>{
        {.name = "edge_radius",
         .dimension = units::Dimension::length,
         .lowest = 0,
         .highest = 1,
         .help = "Radius of the rounded edges of the slider; zero leaves them sharp.",
         .default_value = "\"0 mm\"",
         .source = "the paper's slider is a block"},
        &Flat::edge_radius}};
  }
  double height(const Plan& plan, double x, double y) const override;
  bool sharp() const override { return edge_radius == 0; }
  std::array<double, 2> flat_half_size(const Plan& plan) const override;
  double border(const Plan& plan, const Pressing& pressing, std::size_t direction) const override;
  std::vector<Misfit> misfits(const Plan& plan) const override;
};

} // namespace ionskin::shapes
