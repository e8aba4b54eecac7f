// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/sheet_impedance.hpp"

#include "model_cases.hpp"

#include <gtest/gtest.h>

namespace ionskin::electrochemistry {
namespace {

using Complex = std::complex<double>;

Case strip(ElectrodeContact contact) {
  Case input = verification::model_case();
  input.skin.layers.front().sheet_resistance = 1.0;
  input.skin.layers.back().sheet_resistance = 3.0;
  input.readout.contact = contact;
  return input;
}

/// A third of the metal's resistance comes to that of a cell which conducts little.
TEST(SheetImpedance, AHighImpedanceSeesAThirdOfTheMetal) {
  const Complex cell(1.0, -2.0);
  const double metal = 4.0 * 15e-3 * 15e-3; // times the area of the electrodes
  EXPECT_NEAR(std::abs(SheetImpedance(strip(ElectrodeContact::one_end)).area_impedance(cell) -
                       cell - metal / 3),
              0.0, 1e-5 * metal);
  EXPECT_NEAR(std::abs(SheetImpedance(strip(ElectrodeContact::both_ends)).area_impedance(cell) -
                       cell - metal / 12),
              0.0, 1e-5 * metal);
  EXPECT_EQ(SheetImpedance(strip(ElectrodeContact::everywhere)).area_impedance(cell), cell);
}

TEST(SheetImpedance, ACornerSeesMoreThanTheEndAndLessThanANarrowStrip) {
  const Complex cell(1.0, 0.0);
  const double end =
      SheetImpedance(strip(ElectrodeContact::one_end)).area_impedance(cell).real() - 1.0;
  const double corner =
      SheetImpedance(strip(ElectrodeContact::corner)).area_impedance(cell).real() - 1.0;
  EXPECT_GT(corner, end);
  EXPECT_LT(corner, 2.0 * end);
}

} // namespace
} // namespace ionskin::electrochemistry
