// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/mechanics_error_estimate.hpp"

#include <gtest/gtest.h>

namespace ionskin::study {
namespace {

TEST(MechanicsErrorEstimate, is_the_relative_difference_to_the_companion) {
  const auto errors = estimate_mechanics_errors(
      {{"normal_force_slide", 50.0, "N"},
       {"shear_first_moment_slide", -2e-4, "1"},
       {"rms_current_top", 1e-3, "A"}},
      {{"normal_force_slide", 51.0, "N"}, {"shear_first_moment_slide", -1.9e-4, "1"}});
  ASSERT_EQ(errors.size(), 2u);
  EXPECT_NEAR(errors.at("normal_force_slide"), 0.02, 1e-15);
  EXPECT_NEAR(errors.at("shear_first_moment_slide"), 0.05, 1e-12);
}

TEST(MechanicsErrorEstimate, leaves_out_residuals_and_zeros) {
  const std::vector<readout::Metric> metrics{{"equilibrium_residual", 1e-12, "1"},
                                             {"energy_balance_error", 1e-6, "1"},
                                             {"tangential_force_slide", 0.0, "N"}};
  EXPECT_TRUE(estimate_mechanics_errors(metrics, metrics).empty());
}

TEST(MechanicsErrorEstimate, companion_has_twice_the_mesh_sizes) {
  Case input;
  input.numerics.mesh_refinement = 1.4;
  EXPECT_DOUBLE_EQ(companion_case(input).numerics.mesh_refinement, 0.7);
}

} // namespace
} // namespace ionskin::study
