// SPDX-License-Identifier: Apache-2.0
#include "ionskin/finite_layers/thickness/layer_stiffness.hpp"

#include "ionskin/finite_layers/thickness/lobatto_element.hpp"

#include <Eigen/LU>

#include <cmath>

namespace ionskin::finite_layers {
namespace {

constexpr double thin_layer = 0.5; // k t
constexpr int degree_of_thin_layer = 8;

using Columns = Eigen::Matrix<double, 2, 4>;

/// Displacement of the four waves at a height above the bottom; none exceeds a few units.
Columns wave_displacement(const ElasticLayer& layer, double k, double height) {
  const double below = k * (height - layer.thickness), above = k * height;
  const double fall = std::exp(below), rise = std::exp(-above);
  const double kappa = 3 - 4 * layer.poissons_ratio();
  Columns result;
  result << -fall, -rise, -below * fall, -above * rise, //
      fall, -rise, (below - kappa) * fall, (-above - kappa) * rise;
  return result;
}

/// Tractions on the upper side of a cut at a height.
Columns wave_traction(const ElasticLayer& layer, double k, double height) {
  const double below = k * (height - layer.thickness), above = k * height;
  const double fall = std::exp(below), rise = std::exp(-above);
  const double nu = layer.poissons_ratio(), kappa = 3 - 4 * nu;
  Columns result;
  result << -2 * fall, 2 * rise, (kappa - 1 - 2 * below) * fall, (kappa - 1 + 2 * above) * rise,
      2 * fall, 2 * rise, 2 * (below - 2 * (1 - nu)) * fall, 2 * (above + 2 * (1 - nu)) * rise;
  return layer.shear_modulus * k * result;
}

Eigen::Matrix4d closed_form(const ElasticLayer& layer, double k) {
  Eigen::Matrix4d displacement, traction;
  displacement << wave_displacement(layer, k, 0), wave_displacement(layer, k, layer.thickness);
  traction << -wave_traction(layer, k, 0), wave_traction(layer, k, layer.thickness);
  return displacement.transpose().partialPivLu().solve(traction.transpose()).transpose();
}

/// One element whose inner nodes are eliminated.
Eigen::Matrix4d one_element(const ElasticLayer& layer, double k) {
  const LobattoElement element(degree_of_thin_layer, layer.thickness);
  const Eigen::MatrixXd stiffness = plane_strain_matrix(element, layer, k);
  const Eigen::Index n = degree_of_thin_layer + 1;
  Eigen::Array4i faces;
  faces << 0, static_cast<int>(n), degree_of_thin_layer, static_cast<int>(n) + degree_of_thin_layer;
  Eigen::ArrayXi inner(2 * n - 4);
  for (int i = 1, at = 0; i < degree_of_thin_layer; ++i) {
    inner(at++) = i;
    inner(at++) = static_cast<int>(n) + i;
  }
  const Eigen::MatrixXd coupling = stiffness(inner, faces);
  const Eigen::MatrixXd held = stiffness(inner, inner);
  return stiffness(faces, faces) - coupling.transpose() * held.partialPivLu().solve(coupling);
}

} // namespace

Eigen::Matrix4d plane_strain_stiffness(const ElasticLayer& layer, double wave_number) {
  return wave_number * layer.thickness < thin_layer ? one_element(layer, wave_number)
                                                    : closed_form(layer, wave_number);
}

AntiplaneStiffness antiplane_stiffness(const ElasticLayer& layer, double wave_number) {
  const double depth = wave_number * layer.thickness;
  const double factor = layer.shear_modulus * wave_number;
  return {factor / std::tanh(depth), -factor / std::sinh(depth)};
}

} // namespace ionskin::finite_layers
