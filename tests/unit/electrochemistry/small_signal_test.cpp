// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/small_signal.hpp"

#include "model_cases.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

namespace ionskin::electrochemistry {
namespace {

TEST(SmallSignalCell, IsAResistanceInTheMiddleAndCapacitancesAtTheEnds) {
  const Case input = verification::model_case();
  const DerivedScales scales = derive_scales(input.electrochemistry, 180e-6);
  const SmallSignalCell cell(input);
  // Far below 1/(slow time): two double layers in series, eps/(2 lambda).
  const double low = 1e-4;
  const double series = input.electrochemistry.permittivity / (2.0 * scales.debye_length);
  EXPECT_NEAR(cell.area_impedance(low).imag() * -2.0 * std::numbers::pi * low * series, 1.0, 1e-2);
  // The impedance between the two is that of the bulk, h/sigma.
  EXPECT_NEAR(cell.area_impedance(1.0).real(), 180e-6 / scales.conductivity,
              0.03 * 180e-6 / scales.conductivity);
  // Far above the relaxation: the empty capacitor, eps/h.
  const double high = 1e5, empty = input.electrochemistry.permittivity / 180e-6;
  EXPECT_NEAR(cell.area_impedance(high).imag() * -2.0 * std::numbers::pi * high * empty, 1.0, 1e-3);
}

/// The interface holds what it is said to, and the core is a resistor far beyond.
TEST(SmallSignalCell, AnInterfaceApartFromTheBulkLeavesAPlainResistor) {
  Case input = verification::model_case();
  input.electrochemistry.permittivity = 1.8e-10;
  input.electrochemistry.interface_capacitance = 20.0;
  const double core = 180e-6 / derive_scales(input.electrochemistry, 180e-6).conductivity;
  const SmallSignalCell cell(input);
  EXPECT_NEAR(cell.area_impedance(1e-3).imag() * -2.0 * std::numbers::pi * 1e-3 * 10.0, 1.0, 1e-3);
  for (const double frequency : {1e-3, 1.0, 1e3, 1e6}) {
    EXPECT_NEAR(cell.area_impedance(frequency).real() / core, 1.0, 1e-3) << frequency;
  }
  input.electrochemistry.ion_model = IonModel::steric;
  input.electrochemistry.largest_concentration = 2400.0;
  EXPECT_NEAR(SmallSignalCell(input).area_impedance(1e-3).imag() * -2.0 * std::numbers::pi * 1e-3 *
                  10.0,
              1.0, 1e-3);
}

TEST(SmallSignalCell, AnswersToTheValence) {
  Case input = verification::model_case();
  input.electrochemistry.valence = 2;
  const DerivedScales scales = derive_scales(input.electrochemistry, 180e-6);
  EXPECT_NEAR(SmallSignalCell(input).area_impedance(1.0).real(), 180e-6 / scales.conductivity,
              0.03 * 180e-6 / scales.conductivity);
}

/// Thin double layers hold dilute ions, though a case of them gives no largest concentration.
TEST(SmallSignalCell, IonsOfThinLayersAreDilute) {
  Case input = verification::model_case();
  const std::complex<double> dilute = SmallSignalCell(input).area_impedance(1.0);
  input.electrochemistry.ion_model = IonModel::thin_layers;
  EXPECT_EQ(SmallSignalCell(input).area_impedance(1.0), dilute);
}

/// Far below the charging of the layers the reactance is 1e7 times the resistance.
TEST(SmallSignalCell, TellsAResistanceFarBelowTheReactance) {
  for (const Preset preset : {Preset::coarse, Preset::standard, Preset::fine}) {
    Case input = verification::model_case();
    input.electrochemistry.permittivity = 1.8e-10;
    input.numerics.preset = preset;
    const DerivedScales scales = derive_scales(input.electrochemistry, 180e-6);
    const std::complex<double> found = SmallSignalCell(input).area_impedance(1e-4);
    // docs/model.md (33) for p and exp(-a) towards 0: 2 lambda tau / eps (a - 3/2).
    const double expected = 2 * scales.debye_length * scales.relaxation_time /
                            input.electrochemistry.permittivity * (scales.half_thickness - 1.5);
    EXPECT_NEAR(found.real() / expected, 1, 1e-6);
    EXPECT_LT(found.imag(), -1e5 * found.real());
  }
}

} // namespace
} // namespace ionskin::electrochemistry
