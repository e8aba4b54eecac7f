// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/traction_profile.hpp"

#include <deal.II/base/quadrature_lib.h>

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

std::array<double, 3> TractionProfile::mean_shape_values(double from, double to) const {
  if (sharp_half_size_ == 0) {
    return {1.0 / 6, 2.0 / 3, 1.0 / 6};
  }
  // With x = a sin(angle) the weight dx / sqrt(a^2 - x^2) is that of the angle.
  const auto angle = [&](double x) {
    return std::asin(std::clamp(x / sharp_half_size_, -1.0, 1.0));
  };
  const double first = angle(from), last = angle(to);
  static const dealii::QGauss<1> rule(8);
  std::array<double, 3> mean{};
  for (unsigned int q = 0; q < rule.size(); ++q) {
    const double x = sharp_half_size_ * std::sin(first + (last - first) * rule.point(q)[0]);
    const double t = (x - from) / (to - from);
    mean[0] += rule.weight(q) * (1 - t) * (1 - 2 * t);
    mean[1] += rule.weight(q) * 4 * t * (1 - t);
    mean[2] += rule.weight(q) * t * (2 * t - 1);
  }
  return mean;
}

} // namespace ionskin::mechanics
