// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"

#include <complex>
#include <vector>

namespace ionskin::electrochemistry {

/// Impedance between the leads of a cell whose electrodes have sheet resistances: a line of
/// resistors along the metal and of the cell across it, docs/model.md (69), (71).
class SheetImpedance {
public:
  explicit SheetImpedance(const Case& input);

  /// Impedance of the cell with the resistance of its metal.
  /// @param cell impedance of the cell below equipotential electrodes, times area [ohm m2]
  /// @returns impedance between the leads, times the area of the electrodes [ohm m2]
  std::complex<double> area_impedance(std::complex<double> cell) const;

private:
  std::complex<double> of_corner(std::complex<double> cell) const;

  double resistance_ = 0; ///< of a square of both metals [ohm]; 0 where it does not matter
  double length_, width_; ///< of the skin [m]
  ElectrodeContact contact_;
  // Waves across the skin for a contact at a corner, and the share that each
  // shape of the current along the contact has of them.
  std::vector<double> waves_;               ///< [1/m]
  std::vector<std::vector<double>> shares_; ///< [shape][wave]
  std::vector<double> static_;              ///< sum over all waves of shares over wave, row by row
};

} // namespace ionskin::electrochemistry
