// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/grid/derived_scales.hpp"

#include <gtest/gtest.h>

namespace ionskin::electrochemistry {
namespace {

constexpr Electrochemistry baseline{293.15, 7e-11, 2e-3, 1200.0, 1};

TEST(DerivedScales, BaselineFigures) {
  const DerivedScales scales = derive_scales(baseline, 180e-6);
  EXPECT_NEAR(scales.thermal_voltage, 25.2617e-3, 1e-7);
  EXPECT_NEAR(scales.debye_length, 0.66058e-6, 1e-11);
  EXPECT_NEAR(scales.relaxation_time, 6.2338e-3, 1e-7);
  EXPECT_NEAR(scales.half_thickness, 136.244, 1e-3);
  EXPECT_NEAR(scales.charge_density, 76.4835, 1e-4);
  EXPECT_NEAR(scales.slow_time, 0.849, 5e-4);
  EXPECT_NEAR(180e-6 / scales.conductivity, 5.6104e-4, 1e-8);
  EXPECT_NEAR(nonlinearity(scales, -0.1, 0.05), 0.005 * 136.244, 1e-5);
}

TEST(DerivedScales, HigherValenceShortensTheDebyeLength) {
  Electrochemistry divalent = baseline;
  divalent.valence = 2;
  const DerivedScales one = derive_scales(baseline, 180e-6), two = derive_scales(divalent, 180e-6);
  EXPECT_NEAR(two.debye_length * two.debye_length, 0.5 * one.debye_length * one.debye_length,
              1e-20);
  EXPECT_DOUBLE_EQ(two.thermal_voltage, one.thermal_voltage);
  EXPECT_NEAR(two.conductivity, 2.0 * one.conductivity, 1e-12);
}

} // namespace
} // namespace ionskin::electrochemistry
