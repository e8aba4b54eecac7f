// SPDX-License-Identifier: Apache-2.0
#include "electrochemistry/model_cases.hpp"
#include "electrochemistry/rows.hpp"

#include "ionskin/electrochemistry/small_signal.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <fmt/format.h>
#include <numbers>

namespace ionskin::verification {
namespace {

using Complex = std::complex<double>;
using electrochemistry::DerivedScales;
using electrochemistry::SmallSignalCell;

struct Reference {
  double frequency;
  Complex area_impedance; // [ohm m2]
};
constexpr std::array<Reference, 3> references{{{0.1, {5.5486e-4, -1.05351e-3}},
                                               {1.0, {5.5402e-4, -1.2677e-4}},
                                               {100.0, {3.421e-5, -1.344e-4}}}};

/// docs/model.md (33): Z A = (2 lambda tau/eps) (tanh(q a) + p q a)/(p q^3), p = i omega tau, q =
/// sqrt(1 + p).
Complex closed_form(const Case& input, const DerivedScales& scales, double frequency) {
  const Complex p(0.0, 2.0 * std::numbers::pi * frequency * scales.relaxation_time);
  const Complex q = std::sqrt(1.0 + p);
  const double a = scales.half_thickness;
  return 2.0 * scales.debye_length * scales.relaxation_time / input.electrochemistry.permittivity *
         (std::tanh(q * a) + p * q * a) / (p * q * q * q);
}

/// Largest relative deviation of the complex impedance over five decades, ten points each.
double worst_error(Preset preset, const DerivedScales& scales) {
  Case input = model_case();
  input.numerics.preset = preset;
  const SmallSignalCell cell(input);
  double worst = 0.0;
  for (int i = 0; i <= 50; ++i) {
    const double frequency = 0.01 * std::pow(10.0, 0.1 * i);
    const Complex expected = closed_form(input, scales, frequency);
    worst = std::max(worst, std::abs(cell.area_impedance(frequency) / expected - 1.0));
  }
  return worst;
}

} // namespace

std::vector<Row> impedance_rows() {
  const Case input = model_case();
  const DerivedScales scales =
      electrochemistry::derive_scales(input.electrochemistry, input.skin.core_thickness());
  const SmallSignalCell cell(input);
  std::vector<Row> rows;
  for (const Reference& reference : references) {
    const Complex value = cell.area_impedance(reference.frequency);
    const double tolerance = 5e-3 * std::abs(reference.area_impedance);
    rows.push_back(compare("E4", fmt::format("Re Z A at {} Hz [ohm m2]", reference.frequency),
                           value.real(), reference.area_impedance.real(), tolerance));
    rows.push_back(compare("E4", fmt::format("Im Z A at {} Hz [ohm m2]", reference.frequency),
                           value.imag(), reference.area_impedance.imag(), tolerance));
  }
  rows.push_back(at_most("E4", "relative error of Z, 0.01 Hz to 1 kHz, standard",
                         worst_error(Preset::standard, scales), 5e-3));
  rows.push_back(at_most("E4", "relative error of Z, 0.01 Hz to 1 kHz, fine",
                         worst_error(Preset::fine, scales), 1e-3));
  return rows;
}

} // namespace ionskin::verification
