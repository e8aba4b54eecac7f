// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "electrochemistry/linear_cell.hpp"

#include <cstddef>

namespace ionskin::verification {

/// Waves of a small potential along a side of the linear cell, docs/model.md (66), where a face is
/// cut across the middle of that side.
class StripWaves {
public:
  /// @param length of the side [m]
  /// @param columns of the grid whose waves are summed; 0 for waves of a continuum
  StripWaves(const Case& input, double length, std::size_t columns);

  /// Sum over the odd waves of capacitance per area times the share that a half has of a wave
  /// [F/m2].
  LinearCell::Complex odd_waves(LinearCell::Complex s) const;

private:
  /// Charge by potential of a wave on one face over the grounded other one [F/m2].
  LinearCell::Complex capacitance(LinearCell::Complex s, double wave) const;

  electrochemistry::DerivedScales scales_;
  double capacitance_unit_, length_;
  std::size_t columns_;
};

} // namespace ionskin::verification
