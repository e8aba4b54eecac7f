// SPDX-License-Identifier: Apache-2.0
#include "ionskin/live/contact/live_contact.hpp"

#include "small_skin.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace ionskin::live {
namespace {

/// A contact with its state.
struct Slider {
  explicit Slider(const SkinData& data)
      : contact(data), force(3 * data.area.size()), surface(force.size()) {}

  /// Normal force after a step to an indentation, with a travel along x.
  double press(double indentation, double travel = 0) {
    residual = contact.step(1e-3, {3e-3, 1e-3}, {travel, 0}, {false, indentation},
                            {force, surface, {}, indented, x, y});
    return sum(0);
  }
  /// Sum of a component of the forces: normal, along x, along y.
  double sum(std::size_t component) const {
    double sum = 0;
    for (std::size_t at = component; at < force.size(); at += 3) {
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

TEST(LiveContact, ChangesTheLoadInPartsThatAreStepsOfTheirOwn) {
  SkinData data = sphere_on_many_cells(15);
  const double deepest = data.deepest_indentation, travel = 0.1 * deepest;
  for (const auto& [from, to] : {std::pair{0.9, 0.4}, {0.4, 0.9}}) {
    SCOPED_TRACE(to);
    Slider at_once(data), in_parts(data);
    for (Slider* slider : {&at_once, &in_parts}) {
      slider->press(from * deepest);
      slider->press(from * deepest, travel);
    }
    at_once.press(to * deepest);
    for (int part = 1; part <= 10; ++part) {
      in_parts.press(deepest * std::lerp(from, to, part / 10.0));
    }
    const double limit = 1e-3 * at_once.sum(0);
    ASSERT_GT(std::abs(at_once.sum(1)), 10 * limit);
    for (std::size_t at = 0; at < at_once.force.size(); ++at) {
      EXPECT_NEAR(at_once.force[at], in_parts.force[at], limit) << at;
    }
    EXPECT_NEAR(at_once.sum(1), in_parts.sum(1), limit);
  }
}

TEST(LiveContact, LandsWithinAStepAsInTwentySteps) {
  const SkinData sphere = sphere_on_many_cells(15);
  SkinData flat = sphere;
  flat.gap.assign(flat.area.size(), 0.0);
  SkinData saturating = flat;
  saturating.friction_law = "saturating";
  saturating.friction_parameters = {"strength", "sharpness"};
  saturating.friction_values = {1e6, 2};
  for (const auto& [name, data] :
       {std::pair{"sphere", sphere}, {"flat", flat}, {"saturating", saturating}}) {
    SCOPED_TRACE(name);
    const double deepest = data.deepest_indentation, travel = 0.3 * deepest;
    Slider at_once(data), in_steps(data);
    at_once.press(deepest, travel);
    for (int step = 1; step <= 20; ++step) {
      in_steps.press(deepest * step / 20, travel / 20);
    }
    const double limit = 1e-3 * at_once.sum(0);
    ASSERT_GT(std::abs(at_once.sum(1)), 10 * limit);
    for (std::size_t at = 0; at < at_once.force.size(); ++at) {
      EXPECT_NEAR(at_once.force[at], in_steps.force[at], limit) << at;
    }
    EXPECT_NEAR(at_once.sum(1), in_steps.sum(1), limit);
  }
}

} // namespace
} // namespace ionskin::live
