// SPDX-License-Identifier: Apache-2.0
#include "ionskin/laws/shear/shear_measure.hpp"

#include "ionskin/laws/shear/deviatoric_shear.hpp"
#include "ionskin/laws/shear/off_diagonal_shear.hpp"
#include "ionskin/laws/shear/signed_xz_shear.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace ionskin::laws {
namespace {

using Strain = std::array<double, 6>; // xx, yy, zz, yz, xz, xy
constexpr Strain any_strain{0.011, -0.007, 0.003, 0.004, -0.009, 0.002};

/// R e R^T for a rotation about an axis through the origin.
Strain rotated(const Strain& e, const std::array<double, 3>& axis, double angle) {
  const double s = std::sin(angle), c = std::cos(angle);
  const std::array<double, 9> cross{0,        -axis[2], axis[1], axis[2], 0,
                                    -axis[0], -axis[1], axis[0], 0};
  std::array<double, 9> r{}, full{e[0], e[5], e[4], e[5], e[1], e[3], e[4], e[3], e[2]}, result{};
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      r[3 * i + j] = (i == j ? c : 0.0) + s * cross[3 * i + j] + (1 - c) * axis[i] * axis[j];
    }
  }
  for (int i = 0; i < 9; ++i) {
    for (int k = 0; k < 9; ++k) {
      result[i] += r[3 * (i / 3) + k / 3] * full[k] * r[3 * (i % 3) + k % 3];
    }
  }
  return {result[0], result[4], result[8], result[5], result[2], result[1]};
}

TEST(ShearMeasure, SimpleShearGivesTheEngineeringShear) {
  const double engineering_shear = 0.02;
  const Strain strain{0, 0, 0, 0, engineering_shear / 2, 0};
  EXPECT_DOUBLE_EQ(OffDiagonalShear::at(strain), engineering_shear);
  EXPECT_DOUBLE_EQ(DeviatoricShear::at(strain), engineering_shear);
  EXPECT_DOUBLE_EQ(SignedXzShear::at(strain), engineering_shear);
  EXPECT_DOUBLE_EQ(SignedXzShear::at({0, 0, 0, 0, -engineering_shear / 2, 0}), -engineering_shear);
}

TEST(ShearMeasure, DeviatoricDoesNotDependOnTheAxes) {
  const double once = DeviatoricShear::at(any_strain);
  for (const double angle : {0.3, 1.2, 2.9}) {
    const Strain turned = rotated(any_strain, {0.6, -0.48, 0.64}, angle);
    EXPECT_NEAR(DeviatoricShear::at(turned), once, 1e-15);
  }
}

TEST(ShearMeasure, OffDiagonalDependsOnTheAxes) {
  const Strain stretch{0.01, -0.01, 0, 0, 0, 0};
  EXPECT_EQ(OffDiagonalShear::at(stretch), 0);
  EXPECT_NEAR(OffDiagonalShear::at(rotated(stretch, {0, 0, 1}, std::acos(-1.0) / 4)), 0.02, 1e-16);
}

TEST(ShearMeasure, DeviatoricIgnoresVolumeAndCountsStretch) {
  EXPECT_NEAR(DeviatoricShear::at({0.1, 0.1, 0.1, 0, 0, 0}), 0, 1e-16);
  // Uniaxial, incompressible: e' = e = (1, -1/2, -1/2), sqrt(2 * 3/2).
  EXPECT_NEAR(DeviatoricShear::at({0.02, -0.01, -0.01, 0, 0, 0}), 0.02 * std::sqrt(3.0), 1e-16);
}

TEST(ShearMeasure, EvenUnderReflectionInY) {
  const auto& [xx, yy, zz, yz, xz, xy] = any_strain;
  for (const ShearMeasure& measure : shear_measures()) {
    EXPECT_DOUBLE_EQ(measure.at({xx, yy, zz, -yz, xz, -xy}), measure.at(any_strain))
        << measure.name;
  }
}

TEST(ShearMeasure, OnlyTheSignedOneTurnsRoundWithMirroredSliding) {
  const auto& [xx, yy, zz, yz, xz, xy] = any_strain;
  for (const ShearMeasure& measure : shear_measures()) {
    const double sign = measure.name == "signed-xz" ? -1 : 1;
    EXPECT_DOUBLE_EQ(measure.at({xx, yy, zz, yz, -xz, -xy}), sign * measure.at(any_strain))
        << measure.name;
  }
}

TEST(ShearMeasure, RowSaysItsFormula) {
  ASSERT_EQ(shear_measures().front().name, "off-diagonal");
  for (const ShearMeasure& measure : shear_measures()) {
    EXPECT_EQ(&shear_measure(measure.name), &measure);
    EXPECT_FALSE(measure.formula.empty());
  }
  EXPECT_THROW(shear_measure("nothing"), std::logic_error);
}

TEST(ShearMeasure, IgnoresStretchAndSign) {
  EXPECT_DOUBLE_EQ(OffDiagonalShear::at({0.1, -0.2, 0.3, 0, 0, 0}), 0);
  EXPECT_DOUBLE_EQ(OffDiagonalShear::at({0, 0, 0, -1e-3, 2e-3, -2e-3}), 6e-3);
}

TEST(ShearMeasure, IsHomogeneousOfDegreeOne) {
  std::array<std::vector<double>, 6> strain;
  for (std::size_t c = 0; c < 6; ++c) {
    strain[c] = {0.1 * static_cast<double>(c), -0.3, 0.7};
  }
  const std::vector<double> once = evaluate_shear(shear_measure("off-diagonal"), strain);
  for (auto& component : strain) {
    for (double& value : component) {
      value *= 2.5;
    }
  }
  const std::vector<double> scaled = evaluate_shear(shear_measure("off-diagonal"), strain);
  for (std::size_t i = 0; i < once.size(); ++i) {
    EXPECT_NEAR(scaled[i], 2.5 * once[i], 1e-15);
  }
}

TEST(ShearMeasure, DependsOnTheComponentsThatItSaysItReads) {
  for (const ShearMeasure& measure : shear_measures()) {
    for (std::size_t c = 0; c < 6; ++c) {
      Strain changed = any_strain;
      changed[c] = measure.reads[c] ? 2 * any_strain[c] : std::nan("");
      if (measure.reads[c]) {
        EXPECT_NE(measure.at(changed), measure.at(any_strain)) << measure.name << ", " << c;
      } else {
        EXPECT_EQ(measure.at(changed), measure.at(any_strain)) << measure.name << ", " << c;
      }
    }
  }
}

TEST(ShearMeasure, OfAComponentThatNobodyComputedIsNotANumber) {
  std::array<std::vector<double>, 6> strain;
  strain[5] = {0.01, 0.02};
  const std::vector<double> shear = evaluate_shear(shear_measure("off-diagonal"), strain);
  ASSERT_EQ(shear.size(), 2U);
  EXPECT_TRUE(std::isnan(shear[0]) && std::isnan(shear[1]));
}

} // namespace
} // namespace ionskin::laws
