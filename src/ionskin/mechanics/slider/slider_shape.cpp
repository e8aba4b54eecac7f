// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/slider/slider_shape.hpp"

#include <algorithm>
#include <cmath>

namespace ionskin::mechanics {

Underside::Underside(const Slider& slider, const shapes::Pose& pose)
    : plan_(slider.plan()), shape_(slider.underside(pose)),
      flat_(shape_->sharp() && !pose.tilted()),
      turned_(!shape_->sharp() && (pose.yaw != 0 || slider.changing.yaw)),
      lowest_(shape_->lowest(plan_)) {}

double Underside::gap(double x, double y) const {
  if (flat_) {
    return 0;
  }
  const double margin = 1 + 1e-9;
  if (std::abs(x) > plan_.size[0] / 2 * margin || std::abs(y) > plan_.size[1] / 2 * margin) {
    return shapes::unreachable_gap;
  }
  return shape_->height(plan_, x, y) - lowest_;
}

double Underside::mean_gap(const std::array<double, 2>& low, const std::array<double, 2>& high,
                           const std::array<bool, 2>& reflect) const {
  // Gauss points and weights of the unit interval, exact to degree five.
  static const double offset = std::sqrt(0.15);
  static const std::array<double, 3> point{0.5 - offset, 0.5, 0.5 + offset};
  constexpr std::array<double, 3> weight{5.0 / 18, 8.0 / 18, 5.0 / 18};
  constexpr double beyond = shapes::unreachable_gap / 2;
  double mean = 0, covered = 0, of_covered = 0;
  for (std::size_t a = 0; a < 9; ++a) {
    const double x = low[0] + point[a % 3] * (high[0] - low[0]);
    const double y = low[1] + point[a / 3] * (high[1] - low[1]);
    const double share = weight[a % 3] * weight[a / 3];
    const double at = gap(reflect[0] ? -x : x, reflect[1] ? -y : y);
    mean += share * at;
    if (at < beyond) {
      covered += share;
      of_covered += share * at;
    }
  }
  return turned_ && covered > 0.5 ? of_covered / covered : mean;
}

std::vector<double> mean_gap(const Slider& slider, const std::vector<double>& lines_x,
                             const std::vector<double>& lines_y,
                             const std::array<bool, 2>& reflect) {
  return mean_gap(slider, slider.pose, lines_x, lines_y, reflect);
}

std::vector<double> mean_gap(const Slider& slider, const shapes::Pose& pose,
                             const std::vector<double>& lines_x, const std::vector<double>& lines_y,
                             const std::array<bool, 2>& reflect) {
  const Underside underside(slider, pose);
  std::vector<double> result;
  for (std::size_t j = 1; j < lines_y.size(); ++j) {
    for (std::size_t i = 1; i < lines_x.size(); ++i) {
      result.push_back(
          underside.mean_gap({lines_x[i - 1], lines_y[j - 1]}, {lines_x[i], lines_y[j]}, reflect));
    }
  }
  return result;
}

} // namespace ionskin::mechanics
