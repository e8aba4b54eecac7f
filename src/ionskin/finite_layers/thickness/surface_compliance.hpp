// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/finite_layers/thickness/cubic_table.hpp"
#include "ionskin/finite_layers/thickness/elastic_layer.hpp"

#include <vector>

namespace ionskin::finite_layers {

/// Amplitudes of the displacement of the top face per amplitude of a traction on it, where
/// tractions vary along the face like a wave [m/Pa].
struct WaveCompliance {
  double normal = 0; ///< displacement upwards per traction upwards
  double along = 0;  ///< displacement along the wave per traction along it
  double across = 0; ///< displacement across the wave per traction across it
  /// Displacement along the wave per traction upwards, equal to the displacement upwards per
  /// traction along the wave.
  double mixed = 0;
};

/// Calculates the compliance of layers on a rigid base by assembling their stiffness matrices
/// upwards.
/// @param layers bottom to top
/// @param wave_number above 0 [1/m]
WaveCompliance wave_compliance(const std::vector<ElasticLayer>& layers, double wave_number);

/// Calculates the compliance of layers on a rigid base under tractions that do not vary along the
/// face, the limit of wave number 0: a column of layers in confined compression and in simple
/// shear.
/// @param layers bottom to top
WaveCompliance uniform_compliance(const std::vector<ElasticLayer>& layers);

/// Calculates the compliance of a half-space of one material, times the wave number [1/Pa],
/// docs/model.md (51).
/// @param layer of the material; its thickness is not read
WaveCompliance half_space_compliance(const ElasticLayer& layer);

/// Compliance of the top face of layers on a rigid base as a function of the wave number. It is
/// tabulated once, and interpolated by cubics in the logarithm of the wave number to 1e-7 of the
/// values.
class SurfaceCompliance {
public:
  /// Tabulates the compliance of layers, bottom to top.
  explicit SurfaceCompliance(std::vector<ElasticLayer> layers);

  /// Interpolates the compliance at a wave number [m/Pa].
  /// @param wave_number 0 or above [1/m]
  WaveCompliance at(double wave_number) const;
  /// Limit of the compliance for short waves, times the wave number: the half-space of the material
  /// of the top layer [1/Pa].
  const WaveCompliance& half_space() const { return half_space_; }
  /// Wave number beyond which the compliance equals the half-space's but for rounding [1/m].
  double half_space_from() const { return last_; }
  /// Thickness of all layers together [m].
  double thickness() const;
  /// Thickness of the top layer [m].
  double top_thickness() const { return layers_.back().thickness; }
  /// Layers, bottom to top.
  const std::vector<ElasticLayer>& layers() const { return layers_; }

private:
  std::vector<ElasticLayer> layers_;
  WaveCompliance uniform_, half_space_;
  double first_ = 0, last_ = 0; ///< smallest and largest wave number of the table [1/m]
  double mixed_slope_ = 0;      ///< mixed compliance of long waves over the wave number [m2/Pa]
  CubicTable table_;            ///< normal, along, across, mixed, each times the wave number [1/Pa]
};

} // namespace ionskin::finite_layers
