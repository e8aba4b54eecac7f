// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"

#include <complex>
#include <vector>

namespace ionskin::electrochemistry {

/// Impedance between the leads of a cell whose electrodes have a sheet resistance: a line of
/// resistors along the metal, with the cell between the two metals, docs/model.md (69), (71).
class SheetImpedance {
public:
  explicit SheetImpedance(const Case& input);

  /// Adds the metal to the impedance of the cell.
  /// @param cell impedance of the cell between equipotential electrodes, times area [ohm m2]
  /// @returns impedance between the leads, times the area of the electrodes [ohm m2]; `cell` for
  ///   metal without resistance
  std::complex<double> area_impedance(std::complex<double> cell) const;

private:
  std::complex<double> of_corner(std::complex<double> cell) const;

  double resistance_ = 0; ///< sum of both sheet resistances [ohm per square]; 0 without
  double length_, width_; ///< of the skin [m]
  ElectrodeContact contact_;
  // Wave numbers across the skin, and the share of each wave in each shape of the current along the
  // lead; empty unless the leads are at a corner.
  std::vector<double> waves_;               ///< [1/m]
  std::vector<std::vector<double>> shares_; ///< [shape][wave]
  /// Sum over all waves of the product of two shapes' shares over the wave number [m],
  /// [shape][shape].
  std::vector<double> static_;
};

} // namespace ionskin::electrochemistry
