// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/mechanics/surface/contact_cells.hpp"

#include <array>
#include <vector>

namespace ionskin::mechanics {

/// Underside of a slider whose angles change, sampled on the contact cells, docs/model.md (77),
/// (78).
class TurningUnderside {
public:
  /// @param slider,cells must outlive this object
  TurningUnderside(const Slider& slider, const ContactCells& cells)
      : slider_(slider), cells_(cells) {}

  /// Pose in which the slider begins.
  const shapes::Pose& first() const { return slider_.pose; }
  /// Mean height of the underside over each cell, above its lowest point, in a pose [m].
  std::vector<double> gap(const shapes::Pose& pose) const;
  /// Displacement of the underside at each cell, along x and y, by a turn about z [m].
  /// @param angle [rad]
  std::vector<std::array<double, 2>> turn(double angle) const;
  /// Displacement of the underside at each cell, as `SteppedInstant::turned` holds it: downwards
  /// (minus the gap), and along x and y by the yaw of the pose [m].
  /// @param gap as `gap(pose)` [m]
  std::vector<std::array<double, 3>> place(const shapes::Pose& pose,
                                           const std::vector<double>& gap) const;

private:
  const Slider& slider_;
  const ContactCells& cells_;
};

} // namespace ionskin::mechanics
