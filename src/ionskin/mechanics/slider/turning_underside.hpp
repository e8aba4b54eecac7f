// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/mechanics/surface/contact_cells.hpp"

#include <array>
#include <vector>

namespace ionskin::mechanics {

/// The underside over the cells of a slider whose angles change, docs/model.md (77), (78).
class TurningUnderside {
public:
  /// @param slider,cells outlive this
  TurningUnderside(const Slider& slider, const ContactCells& cells)
      : slider_(slider), cells_(cells) {}

  const shapes::Pose& first() const { return slider_.pose; }
  /// Mean gap of each cell [m].
  std::vector<double> gap(const shapes::Pose& pose) const;
  /// Displacement of the underside at each cell along x and y by a turn about z [m].
  std::vector<std::array<double, 2>> turn(double angle) const;
  /// Both as ContactSolution keeps them: by how much the underside is lower, and how far it has
  /// turned from a yaw of 0.
  std::vector<std::array<double, 3>> place(const shapes::Pose& pose,
                                           const std::vector<double>& gap) const;

private:
  const Slider& slider_;
  const ContactCells& cells_;
};

} // namespace ionskin::mechanics
