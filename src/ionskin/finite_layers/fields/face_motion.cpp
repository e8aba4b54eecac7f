// SPDX-License-Identifier: Apache-2.0
#include "ionskin/finite_layers/fields/face_motion.hpp"

namespace ionskin::finite_layers {

FaceMotion face_motion(const FieldSkin& skin, const std::array<Eigen::MatrixXd, 3>& forces,
                       bool mirrored) {
  FaceMotion result;
  std::array<Eigen::MatrixXd, 2> stress;
  if (skin.sides != nullptr) {
    for (const Parity parity : parities(mirrored)) {
      Eigen::MatrixXd& own = stress[parity == Parity::even ? 0 : 1];
      own.resize(skin.column->nodes(), skin.sides->modes());
      for (Eigen::Index m = 0; m < own.cols(); ++m) {
        Eigen::MatrixX3d of_mode = Eigen::MatrixX3d::Zero(forces[0].cols(), 3);
        for (Eigen::Index c = 0; c < 3 && m < forces[0].rows(); ++c) {
          of_mode.col(c) = forces[static_cast<std::size_t>(c)].row(m).transpose();
        }
        own.col(m) = skin.sides->stress(m, parity, of_mode);
      }
    }
  }
  if (skin.ends != nullptr) {
    result.ends = skin.ends->motion(forces, mirrored, stress);
  }
  if (skin.sides != nullptr) {
    for (const Parity parity : parities(mirrored)) {
      const std::size_t p = parity == Parity::even ? 0 : 1;
      result.sides[p].resizeLike(stress[p]);
      for (Eigen::Index m = 0; m < stress[p].cols(); ++m) {
        result.sides[p].col(m) = -(m == 0 ? 1 : 2) / skin.length *
                                 skin.sides->stiffness(m, parity).solve(stress[p].col(m));
      }
    }
  }
  return result;
}

} // namespace ionskin::finite_layers
