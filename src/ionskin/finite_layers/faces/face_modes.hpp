// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/finite_layers/faces/thickness_column.hpp"

#include <Eigen/Core>

namespace ionskin::finite_layers {

/// A mode of the skin: cosines and sines of k_x x and k_y y.
struct PlaneMode {
  double x = 0, y = 0; ///< wave numbers [1/m]
};

/// Faces that move: the sides, normal to y, or the ends, normal to x.
enum class Face { side, end };

/// Terms that one mode of the skin holds against its faces where these move outwards though they
/// still carry no shear, docs/model.md (55), with the mode itself eliminated.
struct FaceTerms {
  Eigen::MatrixXd stiffness; ///< of the face's motion at the nodes [N/m]
  /// Normal stress that the roller face feels at the nodes, over tractions of the mode on the top:
  /// normal (downwards), x, y [1].
  Eigen::MatrixX3d stress;
  /// Terms of an end on the sides, over the motion of the end; empty for sides [N/m].
  Eigen::MatrixXd on_sides;
};

FaceTerms face_terms(const ThicknessColumn& column, const PlaneMode& mode, Face face);
/// The stiffness alone, for the many modes that carry no load.
Eigen::MatrixXd face_stiffness(const ThicknessColumn& column, const PlaneMode& mode, Face face);

/// Displacement of the nodes by a mode over the motion of a face, a strain of 1 by (55): along the
/// wave, upwards and across it, [node, node of the face].
struct ModeMotion {
  Eigen::MatrixXd along, upwards, across;
};
ModeMotion mode_motion(const ThicknessColumn& column, const PlaneMode& mode, Face face);

} // namespace ionskin::finite_layers
