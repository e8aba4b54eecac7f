// SPDX-License-Identifier: Apache-2.0
#include "ionskin/handover/measures/shear_measure.hpp"

#include "ionskin/handover/measures/deviatoric_shear.hpp"
#include "ionskin/handover/measures/off_diagonal_shear.hpp"
#include "ionskin/handover/measures/signed_xz_shear.hpp"
#include "ionskin/mechanics/elasticity/core_strain.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace ionskin::handover {
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

/// A strain field of 2 x 2 x 2 points, every component different everywhere.
mechanics::CoreStrain any_field() {
  mechanics::CoreStrain strain;
  strain.points = {2, 2, 2};
  for (std::size_t c = 0; c < 6; ++c) {
    for (std::size_t i = 0; i < 8; ++i) {
      strain.component[c].push_back(std::sin(static_cast<double>(8 * c + i)));
    }
  }
  return strain;
}

TEST(ShearMeasure, SimpleShearGivesTheEngineeringShear) {
  const double engineering_shear = 0.02;
  const Strain strain{0, 0, 0, 0, engineering_shear / 2, 0};
  EXPECT_DOUBLE_EQ(off_diagonal_shear(strain), engineering_shear);
  EXPECT_DOUBLE_EQ(deviatoric_shear(strain), engineering_shear);
  EXPECT_DOUBLE_EQ(signed_xz_shear(strain), engineering_shear);
  EXPECT_DOUBLE_EQ(signed_xz_shear({0, 0, 0, 0, -engineering_shear / 2, 0}), -engineering_shear);
}

TEST(ShearMeasure, DeviatoricDoesNotDependOnTheAxes) {
  const double once = deviatoric_shear(any_strain);
  for (const double angle : {0.3, 1.2, 2.9}) {
    const Strain turned = rotated(any_strain, {0.6, -0.48, 0.64}, angle);
    EXPECT_NEAR(deviatoric_shear(turned), once, 1e-15);
  }
}

TEST(ShearMeasure, OffDiagonalDependsOnTheAxes) {
  const Strain stretch{0.01, -0.01, 0, 0, 0, 0};
  EXPECT_EQ(off_diagonal_shear(stretch), 0);
  EXPECT_NEAR(off_diagonal_shear(rotated(stretch, {0, 0, 1}, std::acos(-1.0) / 4)), 0.02, 1e-16);
}

TEST(ShearMeasure, DeviatoricIgnoresVolumeAndCountsStretch) {
  EXPECT_NEAR(deviatoric_shear({0.1, 0.1, 0.1, 0, 0, 0}), 0, 1e-16);
  // Uniaxial, incompressible: e' = e = (1, -1/2, -1/2), sqrt(2 * 3/2).
  EXPECT_NEAR(deviatoric_shear({0.02, -0.01, -0.01, 0, 0, 0}), 0.02 * std::sqrt(3.0), 1e-16);
}

TEST(ShearMeasure, EvenUnderReflectionInY) {
  const mechanics::CoreStrain strain = any_field();
  const mechanics::CoreStrain image = mirrored(strain, {false, true});
  for (const ShearMeasure measure :
       {ShearMeasure::off_diagonal, ShearMeasure::deviatoric, ShearMeasure::signed_xz}) {
    std::vector<double> original, reflected;
    evaluate_shear(measure, strain.component, original);
    evaluate_shear(measure, image.component, reflected);
    for (std::size_t i = 0; i < 8; ++i) {
      EXPECT_DOUBLE_EQ(reflected[i], original[i ^ 2]) << name(measure);
    }
  }
}

TEST(ShearMeasure, OnlyTheSignedOneTurnsRoundWithMirroredSliding) {
  const mechanics::CoreStrain strain = any_field();
  const mechanics::CoreStrain image = mirrored(strain, {true, false});
  for (const ShearMeasure measure :
       {ShearMeasure::off_diagonal, ShearMeasure::deviatoric, ShearMeasure::signed_xz}) {
    const double sign = measure == ShearMeasure::signed_xz ? -1 : 1;
    std::vector<double> original, reflected;
    evaluate_shear(measure, strain.component, original);
    evaluate_shear(measure, image.component, reflected);
    for (std::size_t i = 0; i < 8; ++i) {
      EXPECT_DOUBLE_EQ(reflected[i], sign * original[i ^ 1]) << name(measure);
    }
  }
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
} // namespace ionskin::handover
