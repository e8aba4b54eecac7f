// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/finite_layers/faces/thickness_column.hpp"

#include <Eigen/Core>

namespace ionskin::finite_layers {

/// Mode of the skin: products of cosines and sines of k_x x and k_y y, docs/model.md (48).
struct PlaneMode {
  double x = 0, y = 0; ///< wave numbers k_x and k_y [1/m]
};

/// Pair of opposite faces that move: the sides, normal to y, or the ends, normal to x.
enum class Face { side, end };

/// Contribution of one mode of the skin to the equations of a pair of faces that move outwards
/// while they carry no shear, docs/model.md (55). The unknowns of the mode itself are eliminated. A
/// motion of 1 at a node is a strain of 1 of the mode, the second term of (55).
struct FaceTerms {
  /// Normal stress, integrated with the shape functions, per motion at the nodes [N/m].
  Eigen::MatrixXd stiffness;
  /// Normal stress on the face while rollers hold it, integrated with the shape functions of the
  /// nodes, per traction of the mode on the top face: normal (downwards), x, y [m].
  Eigen::MatrixX3d stress;
  /// Normal stress that a motion of the ends causes on the sides, integrated with the shape
  /// functions, [node of the side, node of the end] [N/m]; empty for `Face::side`.
  Eigen::MatrixXd on_sides;
};

/// Calculates all terms of a mode, for modes that carry a load.
FaceTerms face_terms(const ThicknessColumn& column, const PlaneMode& mode, Face face);
/// Calculates only `FaceTerms::stiffness`, for the many modes that carry no load.
Eigen::MatrixXd face_stiffness(const ThicknessColumn& column, const PlaneMode& mode, Face face);

/// Displacements of the nodes of a mode per motion of the faces, where a motion of 1 is a strain of
/// 1 by docs/model.md (55): along the wave, upwards and across the wave, [node, node of the face]
/// [m].
struct ModeMotion {
  Eigen::MatrixXd along, upwards, across;
};
/// Calculates the displacements of a mode that a motion of the faces causes.
ModeMotion mode_motion(const ThicknessColumn& column, const PlaneMode& mode, Face face);

} // namespace ionskin::finite_layers
