// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/mesh/skin_mesh.hpp"

#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace ionskin::mechanics {

/// Residual that a contact is solved to at the worst, a given force among it, over the largest
/// normal force of a cell.
inline constexpr double contact_tolerance = 1e-8;

/// Small strain in the core at the 2x2x2 Gauss points of each element (the superconvergent points
/// of Q2 elements, Barlow 1976, doi 10.1002/nme.1620100202). The points form a tensor grid of two
/// points per element and direction, in the mesh's own order; half models hold y <= width / 2 only.
struct CoreStrain {
  std::array<std::size_t, 3> points{}; ///< along x, y, z
  /// Six components xx, yy, zz, yz, xz, xy (tensor components), each [z][y][x], x fastest [1].
  std::array<std::vector<double>, 6> component;
};

/// Strains that are recovered when they are asked for: those of a long path would fill the memory.
class StrainSource {
public:
  virtual ~StrainSource() = default;
  /// Of a state by its place; valid until the next call. Fast when places ascend.
  virtual const CoreStrain& at(std::size_t place) = 0;
  /// Over all states that were asked for: of each electrode layer [Pa], and relative.
  virtual const std::vector<double>& largest_electrode_stress() const = 0;
  virtual double worst_equilibrium_residual() const = 0;
};

/// One converged equilibrium of slider and skin.
struct ContactState {
  double indentation = 0;                   ///< of the slider's lowest point [m]
  double normal_force = 0;                  ///< of the full skin, compression positive [N]
  std::array<double, 2> tangential_force{}; ///< on the skin, full skin, x and y [N]
  /// Per footprint cell, [y][x] with x fastest, half model: y <= width / 2.
  std::vector<double> normal_traction;       ///< [Pa]
  std::vector<double> tangential_traction_x; ///< [Pa]
  std::vector<double> tangential_traction_y; ///< [Pa]
  std::vector<double> surface; ///< mean displacement of each cell: normal downwards, x, y [m]
  /// Length of the slip since the state before on the path [m]; in steady sliding the way of the
  /// leg.
  std::vector<double> slip;
  CoreStrain strain;                    ///< empty where `source` recovers it
  std::shared_ptr<StrainSource> source; ///< null where the strain is held
  std::size_t place = 0;                ///< in the source
  /// Largest von Mises stress of each electrode layer as a membrane, averaged through its thickness
  /// and over each column of elements; bottom to top [Pa].
  std::vector<double> electrode_stress;
  /// Of each cell: how much more tangential traction it takes before it slips; 0 where it slips or
  /// does not touch [Pa].
  std::vector<double> stick_reserve;
  double contact_area = 0; ///< of the full skin, see covered_area.hpp [m2]
  double stick_area = 0;   ///< of it, where nothing slips [m2]
  // By how much whole cells leave the borders of both in doubt, see border_area [m2].
  double contact_border = 0, stick_border = 0;
  double binding_energy = 0; ///< of adhesion, full skin [J]
  // diagnostics
  double equilibrium_residual = 0; ///< contact forces against base reactions, relative
  double complementarity_residual =
      0;                     ///< worst violation of contact and friction conditions, relative
  double stick_fraction = 0; ///< stuck area over contact area
  int iterations = 0;
};

/// Its strain, held or recovered; of the latter valid until the next call.
inline const CoreStrain& core_strain(const ContactState& state) {
  return state.source ? state.source->at(state.place) : state.strain;
}

using SharedState = std::shared_ptr<const ContactState>;

/// A state together with when it is passed.
struct PathState {
  double time = 0;   ///< since the begin of the leg [s]
  SharedState state; ///< null: detached
};

/// The contact during one leg of the motion. States that several legs pass are shared.
///
/// A leg that reaches steady sliding is the sum of steady sliding at the slider's position,
/// interpolated along the leg, and of the deviation of the path from it. The deviation is taken on
/// the mesh of the path's start and fades linearly between the path's last state and `joined`, so
/// that the onset of sliding joins steady sliding without a jump: a jump would be a false current.
struct LegSolution {
  /// From the begin of contact, or of the leg, through every load step; empty where sliding is
  /// steady from the begin, and while detached.
  std::vector<PathState> path;
  /// Steady sliding under the load of each state of `path`, all on the path's mesh; empty when the
  /// leg never slides steadily.
  std::vector<SharedState> reference;
  /// Steady sliding at the interpolation nodes along the leg, first and last are its ends in
  /// contact; empty when the leg never slides steadily.
  std::vector<PathState> steady;
  double joined = 0; ///< when the deviation has faded, since the begin of the leg [s]

  bool in_contact() const { return !path.empty() || !steady.empty(); }
  /// At the end of the leg; null when detached there.
  const SharedState& last() const {
    return steady.empty() ? path.back().state : steady.back().state;
  }
};

/// An instant of a motion that is stepped.
struct SteppedInstant {
  double time = 0;                     ///< since the begin of the cycle [s]
  std::array<double, 2> centre{};      ///< of the slider [m]
  double height = 0;                   ///< of its underside above the undeformed top face [m]
  SharedState state;                   ///< null: detached
  std::array<double, 2> drive_force{}; ///< of a drive on the slider; 0 without load [N]
};

/// All of Study 1 for one friction coefficient. One cycle stands for all: after complete lift-off
/// no stress remains.
struct ContactSolution {
  mesh::SkinMesh mesh;
  std::vector<double> cell_lines_x,
      cell_lines_y;              ///< footprint cell edges from the slider's centre [m]
  std::vector<LegSolution> legs; ///< of one cycle, as motion_legs has them; empty where stepped
  /// The instants of one cycle between which all is linear, where the motion is stepped
  /// (engine/solve_stepped.hpp); empty else.
  std::vector<SteppedInstant> stepped;
  /// Of a stepped motion: instants at which the slider lands, leaves or begins to slide, and from
  /// each begin of sliding to where all of the contact slips [s].
  std::vector<double> stepped_events;
  std::vector<std::array<double, 2>> stepped_onsets;
  /// Surface displacement per cell left after the first lift-off [m]: normal, x, y; zero to
  /// rounding.
  std::vector<double> final_surface;
  std::vector<std::string> warnings;
  double worst_equilibrium_residual = 0;
  double worst_complementarity_residual = 0;
  /// Largest estimate over the legs of the error between the nodes of steady sliding, of the strain
  /// in the core over its largest norm (see interpolation_error.hpp).
  double worst_interpolation_error = 0;
  /// Energy that the contact loses in jumps of adhesion, full skin [J].
  double adhesion_loss = 0;
  int contact_solves = 0;
};

} // namespace ionskin::mechanics
