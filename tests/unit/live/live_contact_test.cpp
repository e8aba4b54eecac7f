// SPDX-License-Identifier: Apache-2.0
#include "ionskin/live/live_contact.hpp"

#include "small_skin.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace ionskin::live {
namespace {

/// Square cells of 0.1 mm under a sphere of 8 mm without friction, on something like an elastic
/// half-space: each cell gives little by itself beside what its neighbours press it down.
SkinData sphere_on_many_cells() {
  constexpr std::size_t across = 15, cells = across * across;
  constexpr double width = 1e-4, radius = 8e-3, softness = 1e-10; // displacement [m2/N] by 1/r
  SkinData data = small_skin();
  data.friction = data.lowest_friction = data.highest_friction = 0;
  data.area.assign(cells, width * width);
  data.gap.clear();
  data.stiffness = 1e6;
  data.compliance = {};
  data.compliance.lines_x = {3e-3};
  data.compliance.lines_y = {1e-3};
  data.compliance.values.assign(9 * cells * cells, 0.0f);
  const auto place = [&](std::size_t cell, std::size_t axis) {
    const std::size_t index = axis == 0 ? cell % across : cell / across;
    return width * (static_cast<double>(index) - static_cast<double>(across / 2));
  };
  for (std::size_t i = 0; i < cells; ++i) {
    const double x = place(i, 0), y = place(i, 1);
    data.gap.push_back((x * x + y * y) / (2 * radius));
    for (std::size_t j = 0; j < cells; ++j) {
      const double r = std::hypot(x - place(j, 0), y - place(j, 1));
      for (std::size_t c = 0; c < 3; ++c) {
        data.compliance.values[(3 * i + c) * 3 * cells + 3 * j + c] =
            static_cast<float>(softness / std::max(r, 0.28 * width));
      }
    }
  }
  return data;
}

/// A contact with its state.
struct Slider {
  explicit Slider(const SkinData& data)
      : contact(data), force(3 * data.area.size()), surface(force.size()) {}

  /// Normal force after a step to an indentation.
  double press(double indentation) {
    residual = contact.step(1e-3, {3e-3, 1e-3}, {0, 0}, {false, indentation},
                            {force, surface, {}, indented, x, y});
    double sum = 0;
    for (std::size_t at = 0; at < force.size(); at += 3) {
      sum += force[at];
    }
    return sum;
  }
  LiveContact contact;
  std::vector<double> force, surface;
  double indented = 0, x = std::numeric_limits<double>::quiet_NaN(), y = x, residual = 0;
};

TEST(LiveContact, IsNotLostWhereTheSliderIsLiftedByMoreThanCellsGiveAlone) {
  const SkinData data = sphere_on_many_cells();
  constexpr double deepest = 2e-5;
  for (const double share : {0.9, 0.5, 0.1, 0.02}) {
    SCOPED_TRACE(share);
    Slider lifted(data), landed(data);
    lifted.press(deepest);
    const double expected = landed.press(share * deepest);
    ASSERT_GT(expected, 0);
    EXPECT_NEAR(lifted.press(share * deepest), expected, 1e-4 * expected);
    EXPECT_LE(lifted.residual, 1e-6);
  }
}

} // namespace
} // namespace ionskin::live
