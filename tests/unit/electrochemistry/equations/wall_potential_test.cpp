// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/equations/wall_potential.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/electrochemistry/ion_transport.hpp"
#include "model_cases.hpp"

#include <gtest/gtest.h>

namespace ionskin::electrochemistry {
namespace {

TEST(WallPotential, IsThatOfTheRunUnderUniformShear) {
  Case input = verification::model_case();
  input.numerics.preset = Preset::coarse;
  const double excess = 0.1;
  input.coupling.coefficient = excess;
  const auto history = verification::linear_step_history(1.0, 1.0, {0.0, 5.0});
  base::Timers timers;
  const IonSolution solution = solve_ion_transport(input, history, {}, timers);
  const auto scales = derive_scales(input.electrochemistry, 180e-6);
  const double estimate = depletion_potential(scales, excess);
  // The edge of the depleted layer is a Debye length wide, and the core's potential moves by V_T.
  EXPECT_NEAR(solution.max_potential.back(), estimate, 0.02 * estimate + scales.potential_scale);
  EXPECT_EQ(depletion_potential(scales, -excess), 0.0);
}

TEST(WallPotential, ThinLayersHaveNoSaneSolutionUnderFixedChargeOnly) {
  Case input = verification::model_case();
  EXPECT_FALSE(no_sane_solution(input, 8e-3));
  input.electrochemistry.permittivity = 7.1e-10;
  EXPECT_TRUE(no_sane_solution(input, 8e-3));
  EXPECT_FALSE(no_sane_solution(input, 8e-6));
  EXPECT_FALSE(no_sane_solution(input, -8e-3));
  input.coupling.law = "column-neutral";
  EXPECT_FALSE(no_sane_solution(input, 8e-3));
}

TEST(WallPotential, RefusesTheHistoryWithReasonAndRemedy) {
  Case input = verification::model_case();
  input.electrochemistry.permittivity = 7.1e-10;
  try {
    check_net_charge(input, verification::linear_step_history(0.0, 0.02, {0.0, 1.0}));
    FAIL() << "no error";
  } catch (const SolverError& error) {
    EXPECT_NE(std::string(error.what()).find(" V between core and electrodes"), std::string::npos);
    EXPECT_NE(error.remedy().find("pair-generation"), std::string::npos);
  }
  input.coupling.coefficient = -0.1;
  EXPECT_NO_THROW(
      check_net_charge(input, verification::linear_step_history(0.0, 0.02, {0.0, 1.0})));
}

} // namespace
} // namespace ionskin::electrochemistry
