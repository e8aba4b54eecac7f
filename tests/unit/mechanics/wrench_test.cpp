// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/solve_contact.hpp"
#include "small_case.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace ionskin::mechanics {
namespace {

/// Forces of the cells times their arms.
std::array<double, 3> moment_of_tractions(const ContactSolution& solution,
                                          const ContactState& state) {
  std::array<double, 3> moment{};
  const auto &x = solution.cell_lines_x, &y = solution.cell_lines_y;
  for (std::size_t j = 0, cell = 0; j + 1 < y.size(); ++j) {
    for (std::size_t i = 0; i + 1 < x.size(); ++i, ++cell) {
      const double cell_area = (x[i + 1] - x[i]) * (y[j + 1] - y[j]), arm_x = (x[i + 1] + x[i]) / 2,
                   arm_y = (y[j + 1] + y[j]) / 2;
      moment[0] -= cell_area * arm_y * state.normal_traction[cell];
      moment[1] += cell_area * arm_x * state.normal_traction[cell];
      moment[2] += cell_area * (arm_x * state.tangential_traction_y[cell] -
                                arm_y * state.tangential_traction_x[cell]);
    }
  }
  return moment;
}

TEST(Wrench, IsThatOfTheTractionsOffTheMiddleOfASkin) {
  Case input = small_case();
  input.slider.start[1] = 0.85e-3;
  input.motion.stroke = 0.4e-3;
  base::Timers timers;
  const ContactSolution solution = solve_contact(input, ContactOptions{}, timers);
  const ContactState& state = *nearest(solution, 1.5).state;
  const auto expected = moment_of_tractions(solution, state);
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_NEAR(state.moment[c], expected[c], 1e-9 * state.normal_force * 1e-3);
    EXPECT_NE(state.moment[c], 0.0);
  }
}

TEST(Wrench, OfHalfAModelIsThatOfTheWhole) {
  base::Timers timers;
  ContactOptions options;
  const ContactSolution half = solve_contact(small_case(), options, timers);
  options.full_model = true;
  const ContactSolution whole = solve_contact(small_case(), options, timers);
  const ContactState &one = *nearest(half, 1.5).state, &other = *nearest(whole, 1.5).state;
  const double scale = 1e-3 * one.normal_force;
  EXPECT_TRUE(half.mesh.half_model());
  EXPECT_GT(std::abs(one.moment[1]), 1e-3 * scale); // friction presses the front harder
  EXPECT_NEAR(one.moment[1], other.moment[1], 1e-6 * scale);
  EXPECT_EQ(one.moment[0], 0.0);
  EXPECT_EQ(one.moment[2], 0.0);
  EXPECT_NEAR(other.moment[0], 0.0, 1e-9 * scale);
  EXPECT_NEAR(other.moment[2], 0.0, 1e-9 * scale);
}

} // namespace
} // namespace ionskin::mechanics
