// SPDX-License-Identifier: Apache-2.0
#include "ionskin/live/live_contact.hpp"

#include "small_skin.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace ionskin::live {
namespace {

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
  SkinData data = sphere_on_many_cells(15);
  data.friction = data.lowest_friction = data.highest_friction = 0;
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
