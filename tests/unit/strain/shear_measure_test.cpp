// SPDX-License-Identifier: Apache-2.0
#include "ionskin/strain/shear_measure.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace ionskin::strain {
namespace {

TEST(ShearMeasure, SimpleShearGivesTheEngineeringShear) {
  const double engineering_shear = 0.02;
  EXPECT_DOUBLE_EQ(off_diagonal_shear({0, 0, 0, 0, engineering_shear / 2, 0}), engineering_shear);
}

TEST(ShearMeasure, IgnoresStretchAndSign) {
  EXPECT_DOUBLE_EQ(off_diagonal_shear({0.1, -0.2, 0.3, 0, 0, 0}), 0);
  EXPECT_DOUBLE_EQ(off_diagonal_shear({0, 0, 0, -1e-3, 2e-3, -2e-3}), 6e-3);
}

TEST(ShearMeasure, IsHomogeneousOfDegreeOne) {
  std::array<std::vector<double>, 6> strain;
  for (std::size_t c = 0; c < 6; ++c) {
    strain[c] = {0.1 * static_cast<double>(c), -0.3, 0.7};
  }
  std::vector<double> once;
  evaluate_shear(ShearMeasure::off_diagonal, strain, once);
  for (auto& component : strain) {
    for (double& value : component) {
      value *= 2.5;
    }
  }
  std::vector<double> scaled;
  evaluate_shear(ShearMeasure::off_diagonal, strain, scaled);
  for (std::size_t i = 0; i < once.size(); ++i) {
    EXPECT_NEAR(scaled[i], 2.5 * once[i], 1e-15);
  }
}

} // namespace
} // namespace ionskin::strain
