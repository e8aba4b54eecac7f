// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace ionskin::laws {

/// Linear, reversible cohesive zone: adhesive traction s between two faces with opening d,
/// docs/model.md (40):
///   s(d) = s0 (1 - d / d0) for 0 <= d < d0, and 0 beyond; w = s0 d0 / 2 is the work of separation.
/// Faces that approach again attract again. It is the linear softening law of fracture mechanics
/// (Hillerborg, Modeer and Petersson 1976, doi 10.1016/0008-8846(76)90007-7), used instead of the
/// constant traction in the gap of Maugis 1992, doi 10.1016/0021-9797(92)90285-T.
struct CohesiveZone {
  double strength = 0; ///< s0, traction at opening 0 [Pa]; 0: no adhesion
  double range = 0;    ///< d0, opening beyond which there is no traction [m]

  bool pulls() const { return strength > 0; }
  /// Adhesive traction s [Pa] at the opening d [m].
  double tension(double opening) const;
  /// Work per area to separate the faces from the opening d [m] [J/m2]; 0 beyond the range.
  double binding_energy(double opening) const;
};

} // namespace ionskin::laws
