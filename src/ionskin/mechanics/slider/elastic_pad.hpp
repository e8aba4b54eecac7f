// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

namespace ionskin::mechanics {

/// What a soft layer that is bonded to a rigid body moves less than a half-space of its material
/// under a point force on its face, docs/model.md (37). Both move alike close to the force, so that
/// the difference is smooth. Unit: distance / thickness in, amounts of 1 / (2 pi G thickness) out.
class PadStiffening {
public:
  /// @param poissons_ratio of the layer
  explicit PadStiffening(double poissons_ratio);

  struct Values {
    double normal = 0;     ///< along the normal, by a normal force
    double isotropic = 0;  ///< tangential, along a tangential force
    double deviatoric = 0; ///< tangential, times 2 r r^T / r^2 - 1
    double radial = 0;     ///< tangential and away from the place, by a normal force
  };
  /// @param distance over the thickness, not negative
  Values at(double distance) const;

private:
  Values half_space(double distance) const;

  double poissons_ratio_;
  std::vector<Values> table_; ///< at equal distances
};

/// Compliance of the layer under a load that varies like cos(k x) along its face, times G k; of a
/// half-space where it is deep. Under the load's own direction: `normal`, `along` the wave,
/// `across` it; `mixed`: along the wave by a normal load.
struct WaveCompliance {
  double normal = 0, along = 0, across = 0, mixed = 0;
};
/// @param depth k times the thickness
WaveCompliance wave_compliance(double depth, double poissons_ratio);

} // namespace ionskin::mechanics
