// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace ionskin::laws {

/// Two faces that pull each other while they are apart by less than a range, docs/model.md (40):
///   s(d) = s0 (1 - d / d0) for 0 <= d < d0, and 0 beyond; w = s0 d0 / 2 is the work to part them.
/// Reversible: they pull again when they come near again. The linear cohesive zone of fracture
/// mechanics (Hillerborg, Modeer and Petersson 1976, doi 10.1016/0008-8846(76)90007-7) in the place
/// of the constant traction in the gap of Maugis 1992, doi 10.1016/0021-9797(92)90285-T.
struct CohesiveZone {
  double strength = 0; ///< s0, where the faces touch [Pa]; 0: they do not pull
  double range = 0;    ///< d0 [m]

  bool pulls() const { return strength > 0; }
  /// s [Pa] of the opening d [m].
  double tension(double opening) const;
  /// Energy of binding: by how much it is below that of faces far apart [J/m2].
  double binding_energy(double opening) const;
};

} // namespace ionskin::laws
