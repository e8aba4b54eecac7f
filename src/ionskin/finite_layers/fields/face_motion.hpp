// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/finite_layers/fields/field_skin.hpp"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace ionskin::finite_layers {

/// Outward motion of the free faces of a skin, as coefficients of cosines along the faces; made by
/// `face_motion`.
struct FaceMotion {
  /// [even or odd n][node, m] [m]; empty where rollers hold the sides.
  std::array<Eigen::MatrixXd, 2> sides;
  std::vector<FreeEnds::Motion> ends;
};

/// Calculates the motion at which the free faces carry no stress, under forces on the cells.
/// @param forces sums over the cells of the force times the means of the mode: normal (downwards),
/// x, y, each [m, n] [N]
/// @param mirrored true if only even n occur
FaceMotion face_motion(const FieldSkin& skin, const std::array<Eigen::MatrixXd, 3>& forces,
                       bool mirrored);

} // namespace ionskin::finite_layers
