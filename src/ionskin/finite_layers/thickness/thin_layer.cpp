// SPDX-License-Identifier: Apache-2.0
#include "ionskin/finite_layers/thickness/thin_layer.hpp"

#include <Eigen/LU>

namespace ionskin::finite_layers {
namespace {

constexpr int degree_of_thin_layer = 8;

/// Element of one layer, scaled from an element that is made once.
LobattoElement element_of(double thickness) {
  static const LobattoElement of_unit_size(degree_of_thin_layer, 1);
  return of_unit_size.scaled_to(thickness);
}

} // namespace

ThinLayer::ThinLayer(const ElasticLayer& layer, double wave_number)
    : element_(element_of(layer.thickness)) {
  const Eigen::MatrixXd all = plane_strain_matrix(element_, layer, wave_number);
  constexpr int degree = degree_of_thin_layer;
  const Eigen::Index n = degree + 1;
  Eigen::Array4i faces;
  faces << 0, static_cast<int>(n), degree, static_cast<int>(n) + degree;
  Eigen::ArrayXi inner(2 * n - 4);
  for (int i = 1, at = 0; i < degree; ++i) {
    inner(at++) = i;
    inner(at++) = static_cast<int>(n) + i;
  }
  const Eigen::MatrixXd coupling = all(inner, faces);
  const Eigen::MatrixXd held = all(inner, inner);
  const Eigen::MatrixXd follows = -held.partialPivLu().solve(coupling);
  stiffness_ = all(faces, faces) + coupling.transpose() * follows;
  Eigen::MatrixX4d nodes = Eigen::MatrixX4d::Zero(2 * n, 4);
  nodes(faces, Eigen::all).setIdentity();
  nodes(inner, Eigen::all) = follows;
  along_ = nodes.topRows(n);
  upwards_ = nodes.bottomRows(n);
}

} // namespace ionskin::finite_layers
