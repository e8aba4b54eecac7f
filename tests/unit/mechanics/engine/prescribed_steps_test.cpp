// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/engine/prescribed_steps.hpp"

#include "ionskin/base/error.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace ionskin::mechanics {
namespace {

/// One cell on a spring that takes no step longer than a limit.
struct ShortStepper {
  double last = 0, longest;
  SlidingContact contact;

  explicit ShortStepper(double longest_step)
      : longest(longest_step), contact(
                                   [this](const auto& place, ContactProblem& problem) {
                                     if (std::abs(place[0] - last) > longest) {
                                       throw SolverError("too far", "shorter steps");
                                     }
                                     last = place[0];
                                     problem.compliance = 1e-7 * Eigen::MatrixXd::Identity(3, 3);
                                   },
                                   {1e-8}, {0.0}, laws::friction("coulomb", 0.3, {})) {}
};

constexpr MotionLeg along_x{Phase::slide, 0, 1, {0, 0}, {1e-3, 0}, {false, -1e-6}, {false, -1e-6}};

TEST(PrescribedSteps, AreHalvedWhereTheContactHasNoSolution) {
  ShortStepper at(0.3e-3);
  at.contact.step(1, along_x.from, {LoadKind::indentation, 1e-6});
  PrescribedSteps steps(at.contact);
  std::vector<double> told;
  const LegLevels levels = leg_levels(along_x, at.contact, along_x.to, 1);
  EXPECT_EQ(steps.advance(along_x, levels, 0, 1,
                          [&](const PassedStep& step) {
                            told.push_back(step.fraction);
                            return 0.0;
                          }),
            1);
  EXPECT_EQ(steps.steps(), 4);
  EXPECT_EQ(told, std::vector<double>{1});
  EXPECT_EQ(at.contact.place()[0], 1e-3);
}

TEST(PrescribedSteps, AreGivenUpWhereHalvingDoesNotHelp) {
  ShortStepper at(1e-6);
  at.contact.step(1, along_x.from, {LoadKind::indentation, 1e-6});
  PrescribedSteps steps(at.contact);
  const LegLevels levels = leg_levels(along_x, at.contact, along_x.to, 1);
  EXPECT_THROW(steps.advance(along_x, levels, 0, 1, [](const PassedStep&) { return 0.0; }),
               SolverError);
}

} // namespace
} // namespace ionskin::mechanics
