// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/finite_layers/plane/wave_split.hpp"
#include "ionskin/finite_layers/thickness/cubic_table.hpp"
#include "ionskin/finite_layers/thickness/surface_compliance.hpp"

namespace ionskin::finite_layers {

/// Displacement of the face of an unbounded skin at a distance from a point force, at an angle
/// theta from x to y [m/N]. Normal is downwards.
struct RadialCompliance {
  double normal = 0; ///< downwards, of a normal force
  /// Along the radius, of a normal force with the opposite sign; normal, of a force along it.
  double mixed = 0;
  double isotropic = 0;  ///< mean of along and across, of a tangential force
  double deviatoric = 0; ///< by cos 2 theta: of it along x, of a force along x
};

/// Surface compliance of an unbounded body over the distance from a point force. It is that of the
/// half-space of the top layer, which has closed forms, and a difference that is smooth over the
/// thickness of the top layer, docs/model.md (53).
class PlaneCompliance {
public:
  /// Makes the compliance of layers, the share of their short waves.
  PlaneCompliance(const SurfaceCompliance& surface, const WaveSplit& split);
  /// Makes the compliance of a half-space of a material, all waves.
  explicit PlaneCompliance(const ElasticLayer& material);

  /// Less the half-space.
  /// @param distance 0 or above [m]
  RadialCompliance difference(double distance) const;
  /// Compliance of the half-space [m/N]; its parts are over 1/r.
  const RadialCompliance& half_space() const { return half_space_; }
  /// Distance beyond which the sum of both is taken as 0 [m].
  double reach() const { return reach_; }
  /// Length over which the difference varies where it varies most [m].
  double finest() const { return finest_; }

private:
  RadialCompliance half_space_; ///< times the distance
  double reach_, finest_;
  double offset_ = 0; ///< of the distance in the logarithm [m]
  CubicTable table_;  ///< normal, mixed, isotropic, deviatoric; empty: there is no difference
};

} // namespace ionskin::finite_layers
