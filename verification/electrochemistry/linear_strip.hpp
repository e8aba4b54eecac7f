// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "electrochemistry/linear_cell.hpp"

#include <cstddef>

namespace ionskin::verification {

/// Admittance of a linear cell to waves of a small potential along one of its sides, docs/model.md
/// (66), for a face that is cut into two conductors across the middle of that side.
class StripWaves {
public:
  /// @param length length of the side [m]
  /// @param columns number of grid columns, to sum the waves that such a grid has; 0 for the waves
  /// of a continuum
  StripWaves(const Case& input, double length, std::size_t columns);

  /// Sum over the odd waves of capacitance per area times the weight of the wave in one half of the
  /// face [F/m2]: charge per area of a half at unit potential, with the other half at the opposite
  /// potential. `s` is the Laplace variable [1/s].
  LinearCell::Complex odd_waves(LinearCell::Complex s) const;

private:
  /// Charge per area and potential of a wave on one face over the grounded other face [F/m2].
  /// @param wave wave number along the side, times the Debye length [1]
  LinearCell::Complex capacitance(LinearCell::Complex s, double wave) const;

  electrochemistry::DerivedScales scales_;
  double capacitance_unit_, length_;
  std::size_t columns_;
};

} // namespace ionskin::verification
