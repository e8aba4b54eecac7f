// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/finite_layers/thickness/elastic_layer.hpp"

#include <Eigen/Core>

namespace ionskin::finite_layers {

/// Four waves that decay from either face of a layer, in plane strain, at a height above its
/// bottom: (U_r, w) of each. None exceeds a few units.
using WaveColumns = Eigen::Matrix<double, 2, 4>;

WaveColumns wave_displacement(const ElasticLayer& layer, double wave_number, double height);
/// Slopes of the waves upwards [1/m].
WaveColumns wave_slope(const ElasticLayer& layer, double wave_number, double height);
/// Means of the waves over the thickness.
WaveColumns wave_mean(const ElasticLayer& layer, double wave_number);
/// Tractions on the upper side of a cut at a height [Pa/m].
WaveColumns wave_traction(const ElasticLayer& layer, double wave_number, double height);

/// True where the layer is so thin beside the wave that the four become alike.
bool is_thin(const ElasticLayer& layer, double wave_number);

} // namespace ionskin::finite_layers
