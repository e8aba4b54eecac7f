// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/surface/traction_profile.hpp"

#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <cmath>

namespace ionskin::mechanics {

TractionProfile::TractionProfile(const mesh::SkinMesh& mesh, std::size_t direction)
    : sharp_half_size_(0) {
  const std::size_t first = direction == 0 ? mesh.footprint_x()[0] : mesh.footprint_y()[0];
  if (mesh.footprint().sharp(direction) && first > 0) {
    sharp_half_size_ = mesh.footprint().half_size[direction];
  }
}

// With x = a sin(angle) the weight dx / sqrt(a^2 - x^2) is that of the angle.
double TractionProfile::angle(double x) const {
  return std::asin(std::clamp(x / sharp_half_size_, -1.0, 1.0));
}

double TractionProfile::place_of_share(double from, double to, double share) const {
  if (even()) {
    return from + share * (to - from);
  }
  return sharp_half_size_ * std::sin(angle(from) + share * (angle(to) - angle(from)));
}

std::array<double, 3> TractionProfile::mean_shape_values(double from, double to) const {
  if (even()) {
    return {1.0 / 6, 2.0 / 3, 1.0 / 6};
  }
  const double first = angle(from), last = angle(to);
  const auto mean_of = [&](const auto& shape_value) {
    const auto at_angle = [&](double angle_within) {
      const double x = sharp_half_size_ * std::sin(angle_within);
      return shape_value((x - from) / (to - from));
    };
    return boost::math::quadrature::gauss<double, 10>::integrate(at_angle, first, last) /
           (last - first);
  };
  return {mean_of([](double t) { return (1 - t) * (1 - 2 * t); }),
          mean_of([](double t) { return 4 * t * (1 - t); }),
          mean_of([](double t) { return t * (2 * t - 1); })};
}

} // namespace ionskin::mechanics
