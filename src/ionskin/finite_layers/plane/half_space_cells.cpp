// SPDX-License-Identifier: Apache-2.0
#include "ionskin/finite_layers/plane/half_space_cells.hpp"

#include <array>
#include <cmath>

namespace ionskin::finite_layers {
namespace {

/// arsinh(a/|b|), or 0 for b = 0, where callers multiply it by a power of b.
double arsinh_ratio(double a, double b) {
  return b == 0 ? 0.0 : std::asinh(a / std::abs(b));
}

/// arctan(a/b), or 0 for b = 0, where callers multiply it by a power of b.
double arctan_ratio(double a, double b) {
  return b == 0 ? 0.0 : std::atan(a / b);
}

/// Integral of u/r^2, twice along u and twice along v, up to terms that cancel in differences.
double integral_of_u(double u, double v, double square) {
  const double logarithm = square == 0 ? 0.0 : 0.5 * std::log(square);
  return (u * v * v / 2 - u * u * u / 6) * logarithm + v * v * v / 6 * arctan_ratio(u, v) +
         u * u * v / 2 * arctan_ratio(v, u);
}

/// Integrates the kernels twice along u and twice along v.
InverseDistance fourth_integrals(double u, double v) {
  const double square = u * u + v * v, r = std::sqrt(square);
  const double along_u = arsinh_ratio(u, v), along_v = arsinh_ratio(v, u);
  const double by_u = u * v * v / 2 * along_u, by_v = u * u * v / 2 * along_v;
  InverseDistance result;
  result.inverse = by_u + by_v - r * square / 6;
  const double uu = by_u + r * square / 6 - v * v * r / 2; // of u^2/r^3
  const double vv = by_v + r * square / 6 - u * u * r / 2;
  result.cosine = uu - vv;
  result.sine = -(2 * u * v * r + u * u * u * along_v + v * v * v * along_u) / 3;
  result.u = integral_of_u(u, v, square);
  result.v = integral_of_u(v, u, square);
  return result;
}

/// Distances between the ends of two intervals [m], each with its sign in the difference.
std::array<std::array<double, 2>, 4> end_distances(const Interval& at, const Interval& from) {
  return {{{at.to - from.from, 1},
           {at.to - from.to, -1},
           {at.from - from.from, -1},
           {at.from - from.to, 1}}};
}

} // namespace

InverseDistance mean_inverse_distance(const Interval& x_at, const Interval& y_at,
                                      const Interval& x_from, const Interval& y_from) {
  InverseDistance mean;
  for (const auto& [v, sign_v] : end_distances(y_at, y_from)) {
    for (const auto& [u, sign_u] : end_distances(x_at, x_from)) {
      const InverseDistance corner = fourth_integrals(u, v);
      const double sign = sign_u * sign_v;
      mean.inverse += sign * corner.inverse;
      mean.cosine += sign * corner.cosine;
      mean.sine += sign * corner.sine;
      mean.u += sign * corner.u;
      mean.v += sign * corner.v;
    }
  }
  const double areas = x_at.size() * y_at.size() * x_from.size() * y_from.size();
  for (double* value : {&mean.inverse, &mean.cosine, &mean.sine, &mean.u, &mean.v}) {
    *value /= areas;
  }
  return mean;
}

} // namespace ionskin::finite_layers
