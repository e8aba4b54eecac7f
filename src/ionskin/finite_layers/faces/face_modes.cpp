// SPDX-License-Identifier: Apache-2.0
#include "ionskin/finite_layers/faces/face_modes.hpp"

#include "ionskin/base/system/interrupt.hpp"

#include <Eigen/Cholesky>

#include <cmath>

namespace ionskin::finite_layers {
namespace {

/// Direction of the wave of a mode: wave number k [1/m], and its cosine c and sine s [1].
struct Direction {
  double k = 0, c = 1, s = 0;

  explicit Direction(const PlaneMode& mode) : k(std::hypot(mode.x, mode.y)) {
    if (k > 0) {
      c = mode.x / k;
      s = mode.y / k;
    }
  }
};

/// Loads of a mode per motion of a face: in plane strain and across the wave, [unknown, node of the
/// face] [Pa].
struct FaceLoads {
  Eigen::MatrixXd plane_strain, antiplane;
};

FaceLoads face_loads(const ThicknessColumn& column, const PlaneMode& mode, Face face) {
  const Direction at(mode);
  const Eigen::Index n = column.nodes();
  const double q = face == Face::side ? mode.y : mode.x;
  const double along = face == Face::side ? at.s : at.c;
  const double across = face == Face::side ? at.c : -at.s;
  FaceLoads loads{Eigen::MatrixXd(2 * n, n), 2 * q * across * column.shear_mass()};
  loads.plane_strain.topRows(n) = at.k * column.lame_mass() + 2 * q * along * column.shear_mass();
  loads.plane_strain.bottomRows(n) = column.lame_slope();
  return loads;
}

} // namespace

Eigen::MatrixXd face_stiffness(const ThicknessColumn& column, const PlaneMode& mode, Face face) {
  base::check_interrupt(); // a skin with thin layers needs many of these modes
  const double k = Direction(mode).k;
  const FaceLoads loads = face_loads(column, mode, face);
  const Eigen::LLT<Eigen::MatrixXd> plane(column.plane_strain(k)), antiplane(column.antiplane(k));
  const Eigen::MatrixXd half_plane = plane.matrixL().solve(loads.plane_strain),
                        half_antiplane = antiplane.matrixL().solve(loads.antiplane);
  return column.oedometric_mass() - half_plane.transpose() * half_plane -
         half_antiplane.transpose() * half_antiplane;
}

FaceTerms face_terms(const ThicknessColumn& column, const PlaneMode& mode, Face face) {
  base::check_interrupt();
  const Direction at(mode);
  const Eigen::Index n = column.nodes();
  const FaceLoads loads = face_loads(column, mode, face);
  const Eigen::LLT<Eigen::MatrixXd> plane(column.plane_strain(at.k)),
      antiplane(column.antiplane(at.k));
  const Eigen::MatrixXd by_plane = plane.solve(loads.plane_strain),
                        by_antiplane = antiplane.solve(loads.antiplane);
  FaceTerms terms;
  terms.stiffness = column.oedometric_mass() - loads.plane_strain.transpose() * by_plane -
                    loads.antiplane.transpose() * by_antiplane;
  // Betti's theorem: the stress on the face per traction on the top equals the displacement of the
  // top per motion of the face.
  const Eigen::VectorXd along = by_plane.row(n - 1).transpose(),
                        upwards = by_plane.row(2 * n - 1).transpose(),
                        across = by_antiplane.row(n - 1).transpose();
  terms.stress.resize(n, 3);
  terms.stress.col(0) = -upwards;
  terms.stress.col(1) = at.c * along - at.s * across;
  terms.stress.col(2) = at.s * along + at.c * across;
  if (face == Face::end) {
    const FaceLoads sides = face_loads(column, mode, Face::side);
    terms.on_sides = column.lame_mass() - sides.plane_strain.transpose() * by_plane -
                     sides.antiplane.transpose() * by_antiplane;
  }
  return terms;
}

ModeMotion mode_motion(const ThicknessColumn& column, const PlaneMode& mode, Face face) {
  const double k = Direction(mode).k;
  const Eigen::Index n = column.nodes();
  const FaceLoads loads = face_loads(column, mode, face);
  const Eigen::MatrixXd plane = column.plane_strain(k).llt().solve(loads.plane_strain);
  return {-plane.topRows(n), -plane.bottomRows(n),
          -column.antiplane(k).llt().solve(loads.antiplane)};
}

} // namespace ionskin::finite_layers
