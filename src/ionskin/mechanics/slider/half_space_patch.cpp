// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/slider/half_space_patch.hpp"

#include <cmath>

namespace ionskin::mechanics {
namespace {

/// u arsinh(v / |u|), 0 in its limit at u = 0.
double length_times_arsinh(double u, double v) {
  return u == 0 ? 0.0 : u * std::asinh(v / std::abs(u));
}

/// Antiderivative of u/r^2 along both directions, up to a term that cancels over a rectangle.
double radial(double u, double v) {
  const double square = u * u + v * v;
  return (v == 0 ? 0.0 : v * std::log(square) / 2) + (u == 0 ? 0.0 : u * std::atan(v / u));
}

PatchIntegrals corner(double u, double v) {
  PatchIntegrals result;
  result.xx = length_times_arsinh(v, u);
  result.yy = length_times_arsinh(u, v);
  result.xy = -std::hypot(u, v);
  result.x = radial(u, v);
  result.y = radial(v, u);
  return result;
}

void add(PatchIntegrals& sum, const PatchIntegrals& other, double sign) {
  sum.xx += sign * other.xx;
  sum.yy += sign * other.yy;
  sum.xy += sign * other.xy;
  sum.x += sign * other.x;
  sum.y += sign * other.y;
}

} // namespace

PatchIntegrals patch_integrals(double u0, double u1, double v0, double v1) {
  PatchIntegrals sum;
  add(sum, corner(u1, v1), 1);
  add(sum, corner(u0, v1), -1);
  add(sum, corner(u1, v0), -1);
  add(sum, corner(u0, v0), 1);
  sum.inverse = sum.xx + sum.yy;
  return sum;
}

} // namespace ionskin::mechanics
