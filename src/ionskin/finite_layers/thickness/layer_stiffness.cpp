// SPDX-License-Identifier: Apache-2.0
#include "ionskin/finite_layers/thickness/layer_stiffness.hpp"

#include "ionskin/finite_layers/thickness/layer_waves.hpp"
#include "ionskin/finite_layers/thickness/thin_layer.hpp"

#include <Eigen/LU>

#include <cmath>

namespace ionskin::finite_layers {
namespace {

/// Evaluates `plane_strain_stiffness` from the closed-form solutions of a layer.
Eigen::Matrix4d closed_form(const ElasticLayer& layer, double k) {
  Eigen::Matrix4d displacement, traction;
  displacement << wave_displacement(layer, k, 0), wave_displacement(layer, k, layer.thickness);
  traction << -wave_traction(layer, k, 0), wave_traction(layer, k, layer.thickness);
  return displacement.transpose().partialPivLu().solve(traction.transpose()).transpose();
}

} // namespace

Eigen::Matrix4d plane_strain_stiffness(const ElasticLayer& layer, double wave_number) {
  return is_thin(layer, wave_number) ? ThinLayer(layer, wave_number).stiffness()
                                     : closed_form(layer, wave_number);
}

AntiplaneStiffness antiplane_stiffness(const ElasticLayer& layer, double wave_number) {
  const double depth = wave_number * layer.thickness;
  const double factor = layer.shear_modulus * wave_number;
  return {factor / std::tanh(depth), -factor / std::sinh(depth)};
}

} // namespace ionskin::finite_layers
