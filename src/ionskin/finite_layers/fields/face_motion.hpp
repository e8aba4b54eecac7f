// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/finite_layers/fields/field_skin.hpp"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace ionskin::finite_layers {

/// Motion of the faces of a skin outwards under forces, coefficients of cosines along them.
struct FaceMotion {
  std::array<Eigen::MatrixXd, 2> sides; ///< of even and odd modes n, [node, m] [m]
  std::vector<FreeEnds::Motion> ends;
};

/// Motion of the faces of a skin under forces.
/// @param forces sums over cells of force and means of the modes, [m, n]: normal, x, y [N]
/// @param mirrored whether even n alone occur
FaceMotion face_motion(const FieldSkin& skin, const std::array<Eigen::MatrixXd, 3>& forces,
                       bool mirrored);

} // namespace ionskin::finite_layers
