// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/shapes/shape.hpp"

namespace ionskin::shapes {

// Parts that bodies bounded by circles have in common.

/// The key `slider.radius`, which they share.
inline constexpr laws::LawParameter body_radius{.name = "radius",
                                                .dimension = units::Dimension::length,
                                                .lowest = 1e-6,
                                                .highest = 1e3,
                                                .help = "Radius of the round body."};

/// Height of a circle above its lowest point at a distance from it [m], without cancellation near
/// it; `unreachable_gap` beyond the circle.
double arc_height(double radius, double distance);

/// Half width of the contact of a line with a radius [m], bounded by that on an elastic half-space
/// of the softest layer under a given force (Hertz) and by that on a thin bonded incompressible
/// layer, which bulges most, under a given indentation (Johnson, Contact Mechanics, 1985, chapters
/// 4 and 5).
double line_contact(double radius, const Pressing& pressing);

/// A plan that is longer than the diameter along one of the first directions.
std::vector<Misfit> longer_than_diameter(double radius, const Plan& plan, std::size_t directions);

} // namespace ionskin::shapes
