// SPDX-License-Identifier: Apache-2.0
#include "ionskin/finite_layers/thickness/layer_field.hpp"

#include "ionskin/finite_layers/thickness/layer_waves.hpp"
#include "ionskin/finite_layers/thickness/thin_layer.hpp"

#include <Eigen/LU>

#include <cmath>

namespace ionskin::finite_layers {
namespace {

/// Evaluates `plane_strain_field` from the closed-form solutions of a layer.
Eigen::Matrix4d closed_form(const ElasticLayer& layer, double k, LayerHeight height) {
  Eigen::Matrix4d faces;
  faces << wave_displacement(layer, k, 0), wave_displacement(layer, k, layer.thickness);
  const WaveColumns value = height ? wave_displacement(layer, k, *height) : wave_mean(layer, k);
  const WaveColumns slope =
      height ? wave_slope(layer, k, *height)
             : WaveColumns((faces.bottomRows<2>() - faces.topRows<2>()) / layer.thickness);
  Eigen::Matrix4d waves;
  waves << value.row(0), slope.row(0), value.row(1), slope.row(1);
  return faces.transpose().partialPivLu().solve(waves.transpose()).transpose();
}

/// Evaluates `plane_strain_field` of a thin layer from its finite element.
Eigen::Matrix4d one_element(const ElasticLayer& layer, double k, LayerHeight height) {
  const ThinLayer thin(layer, k);
  const LobattoElement& element = thin.element();
  const Eigen::RowVectorXd value = height ? element.values_at(*height) : element.means(),
                           slope = height ? element.slopes_at(*height) : element.mean_slopes();
  Eigen::Matrix4d field;
  field << value * thin.along(), slope * thin.along(), value * thin.upwards(),
      slope * thin.upwards();
  return field;
}

} // namespace

Eigen::Matrix4d plane_strain_field(const ElasticLayer& layer, double wave_number,
                                   LayerHeight height) {
  return is_thin(layer, wave_number) ? one_element(layer, wave_number, height)
                                     : closed_form(layer, wave_number, height);
}

Eigen::Matrix2d antiplane_field(const ElasticLayer& layer, double wave_number, LayerHeight height) {
  const double t = layer.thickness, depth = wave_number * t;
  Eigen::Matrix2d field;
  if (!height) {
    const double mean = std::tanh(0.5 * depth) / depth;
    field << mean, mean, -1 / t, 1 / t;
    return field;
  }
  // sinh(k z)/sinh(k t) and cosh(k z)/sinh(k t), written with exponentials that do not exceed 1.
  const double from_top = wave_number * (t - *height), from_bottom = wave_number * *height;
  const double whole = -std::expm1(-2 * depth);
  const auto sinh_ratio = [&](double far, double near) {
    return std::exp(-far) * -std::expm1(-2 * near) / whole;
  };
  const auto cosh_ratio = [&](double far, double near) {
    return std::exp(-far) * (1 + std::exp(-2 * near)) / whole;
  };
  field << sinh_ratio(from_bottom, from_top), sinh_ratio(from_top, from_bottom),
      -wave_number * cosh_ratio(from_bottom, from_top),
      wave_number * cosh_ratio(from_top, from_bottom);
  return field;
}

} // namespace ionskin::finite_layers
