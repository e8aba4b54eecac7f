// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/electrochemistry/grid/derived_scales.hpp"
#include "ionskin/electrochemistry/grid/scaled_grid.hpp"
#include "ionskin/electrochemistry/sheet_impedance.hpp"

#include <complex>
#include <vector>

namespace ionskin::electrochemistry {

/// Linear response of the cell to a small alternating voltage about its state at rest (c = c0/v,
/// phi = 0). The response is the same in every column, so that the linearised transport equations
/// are solved in one, on z levels of its own; these are finer than any preset, because one column
/// costs next to nothing.
class SmallSignalCell {
public:
  explicit SmallSignalCell(const Case& input);

  /// Impedance between the leads, with the metal's sheet resistance: voltage over the current into
  /// the top electrode, times the area of the electrode [ohm m2]. Real and imaginary part are each
  /// accurate to 1e-3, however much they differ.
  /// @param frequency [Hz], positive
  std::complex<double> area_impedance(double frequency) const;

private:
  /// Impedance times area [ohm m2] of the core between equipotential electrodes.
  std::complex<double> core_impedance(double frequency) const;

  DerivedScales scales_;
  ScaledGrid grid_;
  /// Thermodynamic factor 1 + c dmu/dc of the ions at rest [1], by which diffusion is faster: 1 for
  /// dilute ions, more for the ion model `steric`.
  double diffusion_;
  SheetImpedance metal_;
};

} // namespace ionskin::electrochemistry
