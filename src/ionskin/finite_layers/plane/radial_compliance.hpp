// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/finite_layers/plane/wave_split.hpp"
#include "ionskin/finite_layers/thickness/cubic_table.hpp"
#include "ionskin/finite_layers/thickness/surface_compliance.hpp"

namespace ionskin::finite_layers {

/// Displacement of the top face of an unbounded skin per point force, at a point whose distance
/// vector from the force has the angle theta from x to y [m/N]. Normal forces and displacements
/// count downwards.
struct RadialCompliance {
  double normal = 0; ///< normal displacement per normal force
  /// Normal displacement per force along the radius, and minus the displacement along the radius
  /// per normal force. The radius points from the force to the point.
  double mixed = 0;
  double isotropic = 0;  ///< mean of displacements along and across the radius per tangential force
  double deviatoric = 0; ///< factor of cos 2 theta in the displacement along x per force along x
};

/// Compliance of the top face of an unbounded body as a function of the distance from a point
/// force, docs/model.md (53). It is the sum of the half-space of the top layer's material, which
/// has a closed form, and a difference that is smooth over the thickness of the top layer and is
/// tabulated.
class PlaneCompliance {
public:
  /// Makes the short-wave share of the compliance of layers.
  PlaneCompliance(const SurfaceCompliance& surface, const WaveSplit& split);
  /// Makes the full compliance of a half-space of one material.
  explicit PlaneCompliance(const ElasticLayer& material);

  /// Interpolates the compliance without its half-space part [m/N]; 0 for a body that is a
  /// half-space.
  /// @param distance from the force, 0 or above [m]
  RadialCompliance difference(double distance) const;
  /// Half-space part of the compliance times the distance [m2/N]: it falls like 1/distance.
  const RadialCompliance& half_space() const { return half_space_; }
  /// Distance beyond which the whole compliance is taken as 0 [m]; infinite for a half-space.
  double reach() const { return reach_; }
  /// Shortest length over which the difference varies [m]; infinite for a half-space.
  double finest() const { return finest_; }

private:
  RadialCompliance half_space_; ///< times the distance [m2/N]
  double reach_, finest_;
  double offset_ = 0; ///< distance added in the logarithm of the table, so that it begins at 0 [m]
  /// Table of normal, mixed, isotropic and deviatoric; empty where there is no difference.
  CubicTable table_;
};

} // namespace ionskin::finite_layers
