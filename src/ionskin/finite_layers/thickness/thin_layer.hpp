// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/finite_layers/thickness/lobatto_element.hpp"

#include <Eigen/Core>

namespace ionskin::finite_layers {

/// A layer that is thin beside a wave, in plane strain: one finite element of degree 8 whose inner
/// nodes follow its faces.
class ThinLayer {
public:
  ThinLayer(const ElasticLayer& layer, double wave_number);

  /// Stiffness of the faces, as `plane_strain_stiffness` has it [Pa/m].
  const Eigen::Matrix4d& stiffness() const { return stiffness_; }
  const LobattoElement& element() const { return element_; }
  /// Displacement along the wave and upwards at the nodes of the element, over that of the faces.
  const Eigen::MatrixX4d& along() const { return along_; }
  const Eigen::MatrixX4d& upwards() const { return upwards_; }

private:
  LobattoElement element_;
  Eigen::Matrix4d stiffness_;
  Eigen::MatrixX4d along_, upwards_;
};

} // namespace ionskin::finite_layers
