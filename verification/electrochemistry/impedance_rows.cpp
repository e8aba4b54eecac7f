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

/// Impedance in closed form, docs/model.md (33), in twice as many digits where the processor has
/// them.
Complex closed_form(const Case& input, double frequency) {
  using Long = std::complex<long double>;
  const DerivedScales scales =
      electrochemistry::derive_scales(input.electrochemistry, input.skin.core_thickness());
  const Long p(0.0L, 2.0L * std::numbers::pi_v<long double> * frequency * scales.relaxation_time);
  const long double a = scales.half_thickness;
  const Long q = std::sqrt(1.0L + p);
  // The tanh of a larger real part is above 1 - 1e-40, of which nothing but 1 is left.
  const Long tanh = (q * a).real() > 50 ? Long(1.0L) : std::tanh(q * a);
  const Long scaled = tanh / (p * q * q * q) + a / (q * q);
  return static_cast<Complex>(scaled) *
         (2.0 * scales.debye_length * scales.relaxation_time / input.electrochemistry.permittivity);
}

/// Largest relative deviations of the real and of the imaginary part of an impedance.
struct WorstErrors {
  double real = 0, imaginary = 0;
};

void widen(const Case& input, WorstErrors& worst) {
  const SmallSignalCell cell(input);
  for (int i = 0; i <= 50; ++i) {
    const double frequency = 1e-4 * std::pow(10.0, 0.2 * i);
    const Complex expected = closed_form(input, frequency), value = cell.area_impedance(frequency);
    worst.real = std::max(worst.real, std::abs(value.real() / expected.real() - 1.0));
    worst.imaginary = std::max(worst.imaginary, std::abs(value.imag() / expected.imag() - 1.0));
  }
}

/// Largest deviations over core thicknesses, diffusivities and ten decades of frequency.
WorstErrors worst_errors(double permittivity) {
  WorstErrors worst;
  for (const double thickness : {10e-6, 30e-6, 180e-6, 1e-3}) {
    for (const double diffusivity : {1e-12, 7e-11, 1e-8}) {
      Case input = model_case();
      input.electrochemistry.permittivity = permittivity;
      input.electrochemistry.diffusivity = diffusivity;
      for (Layer& layer : input.skin.layers) {
        if (layer.role == LayerRole::core) {
          layer.thickness = thickness;
        }
      }
      widen(input, worst);
    }
  }
  return worst;
}

} // namespace

std::vector<Row> impedance_rows() {
  const SmallSignalCell cell(model_case());
  std::vector<Row> rows;
  for (const Reference& reference : references) {
    const Complex value = cell.area_impedance(reference.frequency);
    const double tolerance = 1e-3 * std::abs(reference.area_impedance);
    rows.push_back(compare("E4", fmt::format("Re Z A at {} Hz [ohm m2]", reference.frequency),
                           value.real(), reference.area_impedance.real(), tolerance));
    rows.push_back(compare("E4", fmt::format("Im Z A at {} Hz [ohm m2]", reference.frequency),
                           value.imag(), reference.area_impedance.imag(), tolerance));
  }
  for (const double permittivity : {2e-11, 1.8e-10, 1e-8, 1e-6, 1e-4, 2e-3}) {
    const WorstErrors worst = worst_errors(permittivity);
    const auto name = [&](const char* part) {
      return fmt::format("relative error of {} Z, 0.1 mHz to 1 MHz, cores of 10 um to 1 mm, "
                         "1e-12 to 1e-8 m2/s, {:.2g} F/m",
                         part, permittivity);
    };
    rows.push_back(at_most("E4", name("Re"), worst.real, 1e-3));
    rows.push_back(at_most("E4", name("Im"), worst.imaginary, 1e-3));
  }
  return rows;
}

} // namespace ionskin::verification
