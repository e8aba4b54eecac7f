// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/finite_layers/thickness/elastic_layer.hpp"

#include <Eigen/Core>

namespace ionskin::finite_layers {

/// One vector (along the wave, upwards) in each column, for the four plane-strain solutions of a
/// layer that decay exponentially away from one of its faces: two from the top, two from the
/// bottom. The four are scaled so that no displacement exceeds a few units.
using WaveColumns = Eigen::Matrix<double, 2, 4>;

/// Evaluates the displacements (U_r, w) of the four solutions [1].
/// @param wave_number [1/m]
/// @param height above the bottom of the layer [m]
WaveColumns wave_displacement(const ElasticLayer& layer, double wave_number, double height);
/// Evaluates the derivatives upwards (U_r', w') of the four solutions [1/m].
WaveColumns wave_slope(const ElasticLayer& layer, double wave_number, double height);
/// Calculates the means of the displacements (U_r, w) of the four solutions through the thickness
/// [1].
WaveColumns wave_mean(const ElasticLayer& layer, double wave_number);
/// Evaluates the tractions of the four solutions on a horizontal section at a height, on the side
/// whose outward normal points upwards: along the wave and upwards, per unit of displacement
/// [Pa/m].
WaveColumns wave_traction(const ElasticLayer& layer, double wave_number, double height);

/// True if the layer is so thin in comparison with the wavelength, k t < 1/2, that the four
/// solutions are nearly identical and the closed form loses digits.
bool is_thin(const ElasticLayer& layer, double wave_number);

} // namespace ionskin::finite_layers
