// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/electrochemistry/grid/derived_scales.hpp"

#include <complex>
#include <functional>

namespace ionskin::verification {

/// Amplitude of the step S = amplitude y/a of E3, switched on at t = 0.
inline constexpr double step_amplitude = 0.0015;

/// The linear cell of E3 and E4 in the Laplace domain, per area.
class LinearCell {
public:
  using Complex = std::complex<double>;

  explicit LinearCell(const Case& input);

  /// Charge of the step behind a load [C s/m2]: the cell drives it with its short-circuit current
  /// through its own impedance, Q = Q_short Z/(Z + Z_load).
  /// @param load impedance between the electrodes, times their area [ohm m2]
  Complex charge(Complex s, Complex load) const;
  /// Charge of the step in the short circuit [C s/m2].
  Complex short_charge(Complex s) const;
  /// Voltage of the open cell [V s/m2].
  Complex open_voltage(Complex s) const;
  Complex impedance(Complex s) const; ///< [ohm m2]
  double resistance() const;          ///< h/sigma [ohm m2]

private:
  struct Point {
    Complex p, q, tanh;
  };
  Point at(Complex s) const;

  electrochemistry::DerivedScales scales_;
  double permittivity_;
};

/// Value at `time` of a function given by its Laplace transform, by the fixed Talbot method (Abate
/// and Valko 2004, doi 10.1002/nme.995); the singularities lie on the negative real axis.
double inverse_laplace(const std::function<std::complex<double>(std::complex<double>)>& transform,
                       double time);

} // namespace ionskin::verification
