// SPDX-License-Identifier: Apache-2.0
#include "electrochemistry/linear_cell.hpp"

#include <cmath>
#include <numbers>

namespace ionskin::verification {

using Complex = LinearCell::Complex;

LinearCell::LinearCell(const Case& input)
    : scales_(electrochemistry::derive_scales(input.electrochemistry, input.skin.core_thickness())),
      permittivity_(input.electrochemistry.permittivity) {}

Complex LinearCell::charge(Complex s, Complex load) const {
  return short_charge(s) * impedance(s) / (impedance(s) + load);
}

Complex LinearCell::short_charge(Complex s) const {
  const auto [p, q, tanh] = at(s);
  const double a = scales_.half_thickness;
  return scales_.charge_density * step_amplitude / (a * s) *
         (a / q - tanh / (q * q) + p * q * a * a * a / 3.0) / (tanh + p * q * a);
}

Complex LinearCell::open_voltage(Complex s) const {
  return -s * short_charge(s) * impedance(s);
}

double LinearCell::resistance() const {
  return 2.0 * scales_.half_thickness * scales_.debye_length / scales_.conductivity;
}

LinearCell::Point LinearCell::at(Complex s) const {
  const Complex p = s * scales_.relaxation_time, q = std::sqrt(1.0 + p);
  const Complex decay = std::exp(-2.0 * q * scales_.half_thickness);
  return {p, q, (1.0 - decay) / (1.0 + decay)};
}

Complex LinearCell::impedance(Complex s) const {
  const auto [p, q, tanh] = at(s);
  return 2.0 * scales_.debye_length * scales_.relaxation_time / permittivity_ *
         (tanh + p * q * scales_.half_thickness) / (p * q * q * q);
}

double inverse_laplace(const std::function<Complex(Complex)>& transform, double time) {
  constexpr int points = 20;
  const double scale = 2.0 * points / (5.0 * time);
  double sum = 0.5 * std::exp(scale * time) * transform(Complex(scale)).real();
  for (int k = 1; k < points; ++k) {
    const double angle = k * std::numbers::pi / points, cotangent = 1.0 / std::tan(angle);
    const Complex s = scale * angle * Complex(cotangent, 1.0);
    const Complex slope(1.0, angle + (angle * cotangent - 1.0) * cotangent);
    sum += (std::exp(s * time) * transform(s) * slope).real();
  }
  return sum * scale / points;
}

} // namespace ionskin::verification
