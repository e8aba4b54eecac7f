// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/surface/slider_shape.hpp"

#include <algorithm>
#include <cmath>

namespace ionskin::mechanics {
namespace {

/// Height of a circle above its lowest point, without cancellation near it.
double arc_height(double radius, double distance) {
  if (distance > radius) {
    return unreachable_gap;
  }
  const double ratio = distance / radius;
  return radius * ratio * ratio / (1 + std::sqrt(1 - ratio * ratio));
}

/// The rounded edge runs along the whole border, around the corners too.
double rounded_edge_gap(const Slider& slider, double x, double y) {
  const std::array<double, 2> flat = slider.flat_half_size();
  const double distance =
      std::hypot(std::max(0.0, std::abs(x) - flat[0]), std::max(0.0, std::abs(y) - flat[1]));
  return distance == 0 ? 0.0 : arc_height(slider.edge_radius, distance);
}

} // namespace

Underside::Underside(const Slider& slider) : slider_(slider) {
  if (slider.shape == SliderShape::profile) {
    lowest_ = slider.profile_heights.lowest(slider.size);
  }
}

double Underside::profile_gap(double x, double y) const {
  const HeightMap& map = slider_.profile_heights;
  // Cell edges may lie outside the map by rounding.
  return map.interpolated(std::clamp(x, map.x.front(), map.x.back()),
                          std::clamp(y, map.y.front(), map.y.back())) -
         lowest_;
}

double Underside::gap(double x, double y) const {
  if (slider_.sharp()) {
    return 0;
  }
  const double margin = 1 + 1e-9;
  if (std::abs(x) > slider_.size[0] / 2 * margin || std::abs(y) > slider_.size[1] / 2 * margin) {
    return unreachable_gap;
  }
  switch (slider_.shape) {
  case SliderShape::flat:
    return rounded_edge_gap(slider_, x, y);
  case SliderShape::cylinder:
    return arc_height(slider_.radius, std::abs(x));
  case SliderShape::sphere:
    return arc_height(slider_.radius, std::hypot(x, y));
  case SliderShape::profile:
    break;
  }
  return profile_gap(x, y);
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
