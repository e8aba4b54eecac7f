// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/finite_layers/thickness/cubic_table.hpp"
#include "ionskin/finite_layers/thickness/elastic_layer.hpp"

#include <vector>

namespace ionskin::finite_layers {

/// Displacement of the top face over tractions on it that vary like a wave along the face [m/Pa].
struct WaveCompliance {
  double normal = 0; ///< upwards, over a traction upwards
  double along = 0;  ///< along the wave, over a traction along it
  double across = 0; ///< across the wave, over a traction across it
  /// Along the wave over a traction upwards, and upwards over a traction along it.
  double mixed = 0;
};

/// Compliance of layers on a rigid base, bottom to top, by assembling their stiffnesses upwards.
/// @param wave_number above 0 [1/m]
WaveCompliance wave_compliance(const std::vector<ElasticLayer>& layers, double wave_number);

/// Compliance of layers on a rigid base, bottom to top, under tractions that do not vary along the
/// face: normal and shear of a column.
WaveCompliance uniform_compliance(const std::vector<ElasticLayer>& layers);

/// Compliance of the half-space of one material, times the wave number [1/Pa], docs/model.md (51).
WaveCompliance half_space_compliance(const ElasticLayer& layer);

/// Compliance of the top face over the wave number, tabulated once: cubics in the logarithm
/// of the wave number, to 1e-7 of the values.
class SurfaceCompliance {
public:
  explicit SurfaceCompliance(std::vector<ElasticLayer> layers);

  /// Compliance at a wave number, by interpolation.
  /// @param wave_number 0 or above [1/m]
  WaveCompliance at(double wave_number) const;
  /// Compliance of short waves, times the wave number: that of the half-space of the top layer
  /// [1/Pa].
  const WaveCompliance& half_space() const { return half_space_; }
  /// Wave number beyond which the compliance is that of the half-space to rounding [1/m].
  double half_space_from() const { return last_; }
  /// Thickness of all layers, and of the top layer [m].
  double thickness() const;
  double top_thickness() const { return layers_.back().thickness; }
  const std::vector<ElasticLayer>& layers() const { return layers_; }

private:
  std::vector<ElasticLayer> layers_;
  WaveCompliance uniform_, half_space_;
  double first_ = 0, last_ = 0; ///< wave numbers of the table [1/m]
  double mixed_slope_ = 0;      ///< of the mixed compliance over the wave number, of long waves
  CubicTable table_;            ///< normal, along, across, mixed, each times the wave number
};

} // namespace ionskin::finite_layers
