// SPDX-License-Identifier: Apache-2.0
#include "ionskin/results/slider_surface.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

namespace ionskin::results {
namespace {

std::vector<double> drawn_places(double size, const std::vector<double>& further) {
  constexpr int intervals = 60;
  std::vector<double> result;
  for (int i = 0; i <= intervals; ++i) {
    result.push_back(size / 2 * std::sin(std::numbers::pi * (i - intervals / 2) / intervals));
  }
  std::ranges::copy_if(further, std::back_inserter(result),
                       [&](double place) { return std::abs(place) < size / 2; });
  std::ranges::sort(result);
  return result;
}

} // namespace

SliderSurface slider_surface(const Slider& slider, const std::vector<double>& x,
                             const std::vector<double>& y) {
  const auto shape = slider.underside();
  const shapes::Plan plan = slider.plan();
  const double lowest = shape->lowest(plan);
  SliderSurface surface{drawn_places(plan.size[0], x), drawn_places(plan.size[1], y), {}};
  for (const double row : surface.y) {
    for (const double column : surface.x) {
      surface.height.push_back(shape->height(plan, column, row) - lowest);
    }
  }
  return surface;
}

} // namespace ionskin::results
