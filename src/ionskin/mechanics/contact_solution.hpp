// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/mesh/skin_mesh.hpp"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace ionskin::mechanics {

/// Small strain in the core at the 2x2x2 Gauss points of each element (the superconvergent points
/// of Q2 elements, Barlow 1976, doi 10.1002/nme.1620100202). The points form a tensor grid of two
/// points per element and direction, in the mesh's own order; half models hold y <= width / 2 only.
struct CoreStrain {
  std::array<std::size_t, 3> points{}; ///< along x, y, z
  /// Six components xx, yy, zz, yz, xz, xy (tensor components), each [z][y][x], x fastest [1].
  std::array<std::vector<double>, 6> component;
};

/// One converged equilibrium of slider and skin.
struct ContactState {
  double normal_force = 0;                  ///< of the full skin, compression positive [N]
  std::array<double, 2> tangential_force{}; ///< on the skin, full skin, x and y [N]
  /// Per footprint cell, [y][x] with x fastest, half model: y <= width / 2.
  std::vector<double> normal_traction;       ///< [Pa]
  std::vector<double> tangential_traction_x; ///< [Pa]
  std::vector<double> tangential_traction_y; ///< [Pa]
  /// Length of the slip since the state before on the path [m]; in steady sliding the travel since
  /// the node before.
  std::vector<double> slip;
  CoreStrain strain;
  // diagnostics
  double equilibrium_residual = 0; ///< contact forces against base reactions, relative
  double complementarity_residual =
      0;                     ///< worst violation of contact and friction conditions, relative
  double stick_fraction = 0; ///< stuck area over contact area
  int iterations = 0;
};

/// A state together with where it stands on the path. `parameter` is the fraction of the preload
/// during touchdown and lift-off, the slider travel since the start of the slide [m] during onset,
/// and the arc length along the track [m] in steady sliding.
struct PathState {
  double parameter = 0;
  ContactState state;
};

/// All of Study 1 for one friction coefficient. One cycle stands for all: after complete lift-off
/// no stress remains.
struct ContactSolution {
  mesh::SkinMesh mesh;
  std::vector<double> cell_lines_x,
      cell_lines_y;    ///< footprint cell edges from the slider's centre [m]
  PathState touchdown; ///< at full preload; smaller preloads are proportional (flat slider)
  std::vector<PathState>
      onset; ///< from sticking to nearly steady sliding, all on the mesh of the start
  /// Steady sliding at the interpolation nodes along the track, ascending arc length; first and
  /// last node are the ends of the stroke. Empty for a zero stroke.
  std::vector<PathState> steady;
  std::vector<PathState>
      lift_off; ///< falling fractions of the preload, the last one 0, at the end of track
  /// Surface displacement per cell left after lift-off [m]: normal, x, y; zero to rounding.
  std::vector<double> final_surface;
  std::vector<std::string> warnings;
  double worst_equilibrium_residual = 0;
  double worst_complementarity_residual = 0;
  int contact_solves = 0;
};

} // namespace ionskin::mechanics
