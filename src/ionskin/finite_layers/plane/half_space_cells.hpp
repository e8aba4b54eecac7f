// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace ionskin::finite_layers {

/// Interval from one end to the other, along x or y [m].
struct Interval {
  double from = 0, to = 0;

  double size() const { return to - from; }
  double middle() const { return 0.5 * (from + to); }
};

/// Means of what decays like 1/r, over all pairs of a place in one rectangle and a place in
/// another, with (u, v) from the second to the first and r = sqrt(u^2 + v^2) [1/m].
struct InverseDistance {
  double inverse = 0; ///< of 1/r
  double cosine = 0;  ///< of (u^2 - v^2)/r^3
  double sine = 0;    ///< of 2 u v/r^3
  double u = 0;       ///< of u/r^2
  double v = 0;       ///< of v/r^2
};

/// Mean inverse distance in closed form: each kernel is integrated twice along x and twice along y,
/// and the integrals are differences of these functions at the ends. Digits are lost where
/// rectangles are far apart: ten sizes cost four of them.
/// @param x_at,y_at first rectangle, where it is felt
/// @param x_from,y_from second rectangle, where it acts
InverseDistance mean_inverse_distance(const Interval& x_at, const Interval& y_at,
                                      const Interval& x_from, const Interval& y_from);

} // namespace ionskin::finite_layers
