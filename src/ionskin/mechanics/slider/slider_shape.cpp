// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/slider/slider_shape.hpp"

#include <algorithm>
#include <cmath>

namespace ionskin::mechanics {

Underside::Underside(const Slider& slider)
    : plan_(slider.plan()), shape_(slider.underside()), sharp_(shape_->sharp()),
      lowest_(shape_->lowest(plan_)) {}

double Underside::gap(double x, double y) const {
  if (sharp_) {
    return 0;
  }
  const double margin = 1 + 1e-9;
  if (std::abs(x) > plan_.size[0] / 2 * margin || std::abs(y) > plan_.size[1] / 2 * margin) {
    return shapes::unreachable_gap;
  }
  return shape_->height(plan_, x, y) - lowest_;
}

std::vector<double> mean_gap(const Slider& slider, const std::vector<double>& lines_x,
                             const std::vector<double>& lines_y,
                             const std::array<bool, 2>& reflect) {
  // Gauss points and weights of the unit interval, exact to degree five.
  static const double offset = std::sqrt(0.15);
  static const std::array<double, 3> point{0.5 - offset, 0.5, 0.5 + offset};
  constexpr std::array<double, 3> weight{5.0 / 18, 8.0 / 18, 5.0 / 18};
  const Underside underside(slider);
  std::vector<double> result;
  for (std::size_t j = 1; j < lines_y.size(); ++j) {
    for (std::size_t i = 1; i < lines_x.size(); ++i) {
      double mean = 0;
      for (std::size_t a = 0; a < 9; ++a) {
        const double x = lines_x[i - 1] + point[a % 3] * (lines_x[i] - lines_x[i - 1]);
        const double y = lines_y[j - 1] + point[a / 3] * (lines_y[j] - lines_y[j - 1]);
        mean +=
            weight[a % 3] * weight[a / 3] * underside.gap(reflect[0] ? -x : x, reflect[1] ? -y : y);
      }
      result.push_back(mean);
    }
  }
  return result;
}

} // namespace ionskin::mechanics
