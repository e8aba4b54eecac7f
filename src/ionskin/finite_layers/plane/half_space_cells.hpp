// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace ionskin::finite_layers {

/// Interval from one end to the other, along x or y [m].
struct Interval {
  double from = 0, to = 0;

  double size() const { return to - from; }
  double middle() const { return 0.5 * (from + to); }
};

/// Means of five kernels that decay like 1/r, over all pairs of one point in a first rectangle and
/// one in a second [1/m]. (u, v) is the vector along x and y from the point in the second rectangle
/// to the point in the first, and r = sqrt(u^2 + v^2).
struct InverseDistance {
  double inverse = 0; ///< mean of 1/r
  double cosine = 0;  ///< mean of (u^2 - v^2)/r^3
  double sine = 0;    ///< mean of 2 u v/r^3
  double u = 0;       ///< mean of u/r^2
  double v = 0;       ///< mean of v/r^2
};

/// Calculates the means in closed form. Each kernel is integrated twice along x and twice along y,
/// and the integrals are differences of these functions at the ends of the rectangles. Digits are
/// lost where rectangles are far apart: at a distance of ten sizes, four digits.
/// @param x_at,y_at first rectangle, where the displacement is felt
/// @param x_from,y_from second rectangle, on which the force acts
InverseDistance mean_inverse_distance(const Interval& x_at, const Interval& y_at,
                                      const Interval& x_from, const Interval& y_from);

} // namespace ionskin::finite_layers
