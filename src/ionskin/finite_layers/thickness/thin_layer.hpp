// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/finite_layers/thickness/lobatto_element.hpp"

#include <Eigen/Core>

namespace ionskin::finite_layers {

/// Layer that is thin in comparison with a wavelength, in plane strain, where the closed form loses
/// digits. It is one finite element of degree 8, whose inner nodes are eliminated so that they
/// follow the displacements of the two faces.
class ThinLayer {
public:
  /// Makes the element.
  /// @param wave_number [1/m]
  ThinLayer(const ElasticLayer& layer, double wave_number);

  /// Stiffness of the two faces, in the order of `plane_strain_stiffness` [Pa/m].
  const Eigen::Matrix4d& stiffness() const { return stiffness_; }
  /// Finite element through the thickness of the layer.
  const LobattoElement& element() const { return element_; }
  /// Displacements along the wave at the nodes of the element, per displacement of the faces in the
  /// order of `stiffness`, [node, face component] [1].
  const Eigen::MatrixX4d& along() const { return along_; }
  /// Displacements upwards at the nodes of the element, per displacement of the faces in the order
  /// of `stiffness`, [node, face component] [1].
  const Eigen::MatrixX4d& upwards() const { return upwards_; }

private:
  LobattoElement element_;
  Eigen::Matrix4d stiffness_;
  Eigen::MatrixX4d along_, upwards_;
};

} // namespace ionskin::finite_layers
