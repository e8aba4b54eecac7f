// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/electrochemistry/grid/derived_scales.hpp"
#include "ionskin/electrochemistry/grid/scaled_grid.hpp"
#include "ionskin/electrochemistry/sheet_impedance.hpp"

#include <complex>
#include <vector>

namespace ionskin::electrochemistry {

/// The cell's answer to a small alternating voltage about its rest (c = c0/v, phi = 0), which is
/// the same in every column: the transport equations, linearised, on levels of their own, which are
/// fine whatever the preset, because one column costs next to nothing.
class SmallSignalCell {
public:
  explicit SmallSignalCell(const Case& input);

  /// Voltage between the leads over the current into the top electrode, times the area of the
  /// electrode [ohm m2]. Real and imaginary part are right to 1e-3 each, however much they differ.
  /// @param frequency [Hz], positive
  std::complex<double> area_impedance(double frequency) const;

private:
  /// `area_impedance` [ohm m2] of the core alone, between electrodes that are equipotential.
  std::complex<double> core_impedance(double frequency) const;

  DerivedScales scales_;
  ScaledGrid grid_;
  /// Departure of the concentration between neighbouring levels, over their spacing, that balances
  /// a unit of the field: 1, or more where ions take room.
  double diffusion_;
  SheetImpedance metal_;
};

} // namespace ionskin::electrochemistry
