// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/shapes/shape.hpp"

namespace ionskin::shapes {

// Functions shared by shapes that are bounded by circles: cylinder, sphere, rounded edges.

/// Declaration of the key `slider.radius`, which cylinder and sphere share.
inline constexpr laws::LawParameter body_radius{.name = "radius",
                                                .dimension = units::Dimension::length,
                                                .lowest = 1e-6,
                                                .highest = 1e3,
                                                .help = "Radius of the round body."};

/// Height of a circle above its lowest point [m], without cancellation near that point;
/// `unreachable_gap` beyond the circle.
/// @param radius of the circle [m]
/// @param distance horizontal distance from the lowest point [m], at least 0
double arc_height(double radius, double distance);

/// Upper bound of the half width of a line contact of a cylinder [m]: on an elastic half-space with
/// the given modulus under a given force (Hertz), and on a thin bonded incompressible layer, which
/// bulges most, under a given indentation (Johnson, Contact Mechanics, 1985, chapters 4 and 5). The
/// larger of the two is returned.
/// @param radius of the cylinder [m]
double line_contact(double radius, const Pressing& pressing);

/// Conflicts of a plan that is longer than the diameter of a round body; empty if there are none.
/// @param radius of the body [m]
/// @param directions number of directions to check: 1 for x only, 2 for x and y
std::vector<Misfit> longer_than_diameter(double radius, const Plan& plan, std::size_t directions);

} // namespace ionskin::shapes
