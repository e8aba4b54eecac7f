// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/finite_layers/thickness/elastic_layer.hpp"

#include <Eigen/Core>

#include <optional>

namespace ionskin::finite_layers {

/// A height above the bottom of a layer [m]; none stands for the mean through its thickness.
using LayerHeight = std::optional<double>;

/// Displacement inside a layer under a wave, and its slope upwards [1/m], in the rows U_r, U_r', w,
/// w', over that of its faces: of the bottom along the wave and upwards, then of the top.
Eigen::Matrix4d plane_strain_field(const ElasticLayer& layer, double wave_number,
                                   LayerHeight height);

/// Displacement inside a layer across the wave, and its slope upwards [1/m], in the rows U_t, U_t',
/// over U_t of the bottom and of the top.
Eigen::Matrix2d antiplane_field(const ElasticLayer& layer, double wave_number, LayerHeight height);

} // namespace ionskin::finite_layers
