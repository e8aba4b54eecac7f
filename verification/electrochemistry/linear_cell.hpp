// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/electrochemistry/grid/derived_scales.hpp"

#include <complex>
#include <functional>

namespace ionskin::verification {

/// Amplitude [1] of the relative change of the fixed charge, amplitude y/a, in row set E3: linear
/// through the thickness, odd in the distance y from the middle of the core of half thickness a,
/// switched on at t = 0.
inline constexpr double step_amplitude = 0.0015;

/// Closed-form solution in the Laplace domain of the one-dimensional linear cell, per area of its
/// electrodes: a core between two blocking electrodes. Row sets E3, E4 and others compare the
/// solver with it. `s` is the Laplace variable [1/s].
class LinearCell {
public:
  using Complex = std::complex<double>;

  explicit LinearCell(const Case& input);

  /// Charge that the step drives through a load [C s/m2]. The cell is a source of its short-circuit
  /// current with its own impedance Z in parallel, so that Q = Q_short Z/(Z + Z_load).
  /// @param load impedance between the electrodes, times their area [ohm m2]
  Complex charge(Complex s, Complex load) const;
  /// Charge that the step drives through a short circuit [C s/m2].
  Complex short_charge(Complex s) const;
  /// Voltage of the open cell after the step [V s].
  Complex open_voltage(Complex s) const;
  Complex impedance(Complex s) const; ///< impedance of the cell, times its area [ohm m2]
  double resistance() const; ///< ohmic resistance h/sigma of the core, times its area [ohm m2]

private:
  struct Point {
    Complex p, q, tanh;
  };
  Point at(Complex s) const;

  electrochemistry::DerivedScales scales_;
  double permittivity_;
};

/// Inverts a Laplace transform numerically: value at `time` [s] of the function with the given
/// transform, by the fixed Talbot method (Abate and Valko 2004, doi 10.1002/nme.995). All
/// singularities of the transform must lie on the negative real axis.
double inverse_laplace(const std::function<std::complex<double>(std::complex<double>)>& transform,
                       double time);

} // namespace ionskin::verification
