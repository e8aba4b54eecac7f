// SPDX-License-Identifier: Apache-2.0
#include "ionskin/laws/friction/cell_response.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace ionskin::laws {
namespace {

constexpr double area = 2e-8;

CellTrial trial_of(double normal, TangentialVector tangential) {
  return {.area = area,
          .normal_compliance = 1e-7,
          .tangential_compliance = 1.3e-7,
          .normal = normal,
          .tangential = tangential,
          .time_step = 0.1};
}

TEST(CellResponse, TouchesWhereItIsPressedAndSticksWithinTheLimit) {
  const Friction law = friction("coulomb", 0.5, {});
  const CellResponse open = cell_response(law, trial_of(-1, {3, 0}));
  EXPECT_EQ(open.status, CellStatus::separated);
  EXPECT_EQ(open.normal, 0);
  EXPECT_EQ(open.tangential.traction, (TangentialVector{0, 0}));
  const CellResponse stuck = cell_response(law, trial_of(2, {0.6, -0.5}));
  EXPECT_EQ(stuck.status, CellStatus::sticking);
  EXPECT_EQ(stuck.normal, 2);
  EXPECT_EQ(stuck.tangential.traction, (TangentialVector{0.6, -0.5}));
  const CellResponse slips = cell_response(law, trial_of(2, {3, -4}));
  EXPECT_EQ(slips.status, CellStatus::slipping);
  EXPECT_NEAR(slips.tangential.traction[0], 0.6, 1e-12);
  EXPECT_NEAR(slips.tangential.traction[1], -0.8, 1e-12);
}

TEST(CellResponse, HasTheDerivativesOfItsForces) {
  const Friction coulomb = friction("coulomb", 0.5, {});
  const Friction saturating = friction("saturating", 0.5, {{"strength", 1e8}, {"sharpness", 2}});
  const Friction adhesive =
      friction("adhesive", 0.3, {{"work_of_adhesion", 50}, {"cohesive_strength", 1e8}});
  for (const auto& [law, normal] :
       {std::pair{coulomb, 2.0}, {saturating, 2.0}, {adhesive, 2.0}, {adhesive, -3.0}}) {
    CellTrial trial = trial_of(normal, {3, -4});
    trial.pull = law.adhesion.strength * area;
    trial.pull_slope = law.adhesion.pulls() ? trial.pull / law.adhesion.range : 0;
    const CellResponse at = cell_response(law, trial);
    const double step = 1e-6;
    CellTrial moved = trial;
    moved.normal += step;
    const CellResponse pressed = cell_response(law, moved);
    EXPECT_NEAR((pressed.normal - at.normal) / step, at.normal_by_trial, 1e-5);
    for (std::size_t r = 0; r < 2; ++r) {
      const double change = pressed.tangential.traction[r] - at.tangential.traction[r];
      EXPECT_NEAR(change / step, at.tangential.by_normal[r] * at.normal_by_trial, 1e-5);
      for (std::size_t s = 0; s < 2; ++s) {
        moved = trial;
        moved.tangential[s] += step;
        const CellResponse drawn = cell_response(law, moved);
        EXPECT_NEAR((drawn.tangential.traction[r] - at.tangential.traction[r]) / step,
                    at.tangential.by_trial[r][s], 1e-5);
      }
    }
  }
}

TEST(CellResponse, IsPulledByWhatItsOpeningLeavesOfTheAdhesion) {
  const Friction law =
      friction("adhesive", 0.3, {{"work_of_adhesion", 50}, {"cohesive_strength", 1e8}});
  CellTrial trial = trial_of(-3, {1, 0});
  trial.pull = law.adhesion.strength * area;
  trial.pull_slope = trial.pull / law.adhesion.range;
  const CellResponse pulled = cell_response(law, trial);
  ASSERT_EQ(pulled.status, CellStatus::pulled);
  const double opening = trial.normal_compliance * (pulled.normal - trial.normal);
  EXPECT_GT(opening, 0);
  EXPECT_NEAR(pulled.normal, -area * law.adhesion.tension(opening), 1e-12);
  EXPECT_EQ(pulled.tangential.traction, (TangentialVector{0, 0}));
  trial.normal = -law.adhesion.range / trial.normal_compliance * 1.001;
  EXPECT_EQ(cell_response(law, trial).status, CellStatus::separated);
  trial.normal = -0.999 * trial.pull;
  EXPECT_EQ(cell_response(law, trial).normal, trial.normal); // held on the slider's face
}

TEST(CellResponse, SlidesAlongADirectionThatIsGivenWhateverItsOwnSlip) {
  const Friction law = friction("anisotropic", 0.4, {{"transverse_friction", 0.1}});
  CellTrial trial = trial_of(2, {-7, 5});
  trial.time_step = 0;
  trial.sliding_direction = TangentialVector{0.6, 0.8};
  const CellResponse slides = cell_response(law, trial);
  EXPECT_EQ(slides.status, CellStatus::slipping);
  const double length = std::hypot(0.4 * 0.6, 0.1 * 0.8);
  EXPECT_NEAR(slides.tangential.traction[0], 2 * 0.16 * 0.6 / length, 1e-12);
  EXPECT_NEAR(slides.tangential.traction[1], 2 * 0.01 * 0.8 / length, 1e-12);
  EXPECT_NEAR(slides.tangential.by_normal[0], 0.16 * 0.6 / length, 1e-12);
}

TEST(CellResponse, KeepsWhatIsNotANumber) {
  const CellTrial trial = trial_of(std::numeric_limits<double>::quiet_NaN(), {0, 0});
  EXPECT_TRUE(std::isnan(cell_response(friction("coulomb", 0.5, {}), trial).normal));
}

} // namespace
} // namespace ionskin::laws
