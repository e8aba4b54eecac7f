// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/mesh/skin_mesh.hpp"

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace ionskin::mechanics {

/// Residual that a contact is solved to at the worst, a given force among it, over the largest
/// normal force of a cell.
inline constexpr double contact_tolerance = 1e-9;

/// Small strain in the core in each box between the mesh's lines: means over the four quarters of
/// its plan, at both Gauss points of its height. These points form a tensor grid, in the mesh's own
/// order; half models hold y <= width / 2 only.
struct CoreStrain {
  std::array<std::size_t, 3> points{}; ///< along x, y, z
  /// Six components xx, yy, zz, yz, xz, xy (tensor components), each [z][y][x], x fastest; empty of
  /// those that the case does not read [1].
  std::array<std::vector<double>, 6> component;
};

/// Small strain in all layers of a skin.
struct LayerStrain {
  CoreStrain core;
  /// Strain of the electrode layers, bottom to top in the place of z: means through their thickness
  /// and over each column between the mesh's lines.
  CoreStrain electrodes;
};

/// Strain of all layers of a state by its place, recovered anew.
using LayerStrainAt = std::function<LayerStrain(std::size_t place)>;

/// Strains that are recovered when they are asked for: those of a long path would fill the memory.
class StrainSource {
public:
  virtual ~StrainSource() = default;
  /// Strain of a state by its place; valid until the next call. Fast when places ascend.
  virtual const CoreStrain& at(std::size_t place) = 0;
  /// Makes what the strains of all layers share, once for all states; the source outlives it, and
  /// what `at` gave stays valid.
  virtual LayerStrainAt all_layers() const = 0;
  /// Largest von Mises stress, over all states that were asked for, of each electrode layer as a
  /// membrane, averaged through its thickness and over each column of elements, bottom to top [Pa].
  virtual const std::vector<double>& largest_electrode_stress() const = 0;
  /// Largest difference of the contact forces from the base reactions, relative.
  virtual double worst_equilibrium_residual() const = 0;
};

/// One converged equilibrium of slider and skin.
struct ContactState {
  double indentation = 0;                   ///< of the slider's lowest point [m]
  double normal_force = 0;                  ///< of the full skin, compression positive [N]
  std::array<double, 2> tangential_force{}; ///< on the skin, full skin, x and y [N]
  /// Moment of the forces on the skin about the slider's centre on the undeformed top face, full
  /// skin, about x, y and z, docs/model.md (79) [N m].
  std::array<double, 3> moment{};
  /// Values per footprint cell, [y][x] with x fastest, half model: y <= width / 2.
  std::vector<double> normal_traction;       ///< [Pa]
  std::vector<double> tangential_traction_x; ///< [Pa]
  std::vector<double> tangential_traction_y; ///< [Pa]
  std::vector<double> surface; ///< mean displacement of each cell: normal downwards, x, y [m]
  /// Length of the slip since the state before on the path [m].
  std::vector<double> slip;
  CoreStrain strain;                    ///< empty where `source` recovers it
  std::shared_ptr<StrainSource> source; ///< null where the strain is held
  std::size_t place = 0;                ///< in the source
  /// Reserve of each cell: how much more tangential traction it takes before it slips; 0 where it
  /// slips or does not touch [Pa].
  std::vector<double> stick_reserve;
  double contact_area = 0; ///< of the full skin, see covered_area.hpp [m2]
  double stick_area = 0;   ///< of it, where nothing slips [m2]
  // Areas by which whole cells leave the borders of both in doubt, see border_area [m2].
  double contact_border = 0, stick_border = 0;
  double binding_energy = 0;  ///< of adhesion, full skin [J]
  double friction_energy = 0; ///< stored in the elastic slip of friction, full skin [J]
  // diagnostics
  double complementarity_residual =
      0;                     ///< worst violation of contact and friction conditions, relative
  double stick_fraction = 0; ///< stuck area over contact area
  int iterations = 0;
};

/// Strain of a state, held or recovered; of the latter valid until the next call.
inline const CoreStrain& core_strain(const ContactState& state) {
  return state.source ? state.source->at(state.place) : state.strain;
}

using SharedState = std::shared_ptr<const ContactState>;

/// An instant of the motion.
struct SteppedInstant {
  double time = 0;                     ///< since the begin of the cycle [s]
  std::array<double, 2> centre{};      ///< of the slider [m]
  double height = 0;                   ///< of its underside above the undeformed top face [m]
  SharedState state;                   ///< null: detached
  std::array<double, 2> drive_force{}; ///< of a drive on the slider; 0 without load [N]
  /// Place of the slider's underside at each cell from that of a slider that does not turn: normal
  /// downwards, along x, along y, of which differences between instants count [m]. Null where its
  /// angles never change.
  std::shared_ptr<const std::vector<std::array<double, 3>>> turned = {};
};

/// All of Study 1 for one friction coefficient. One cycle stands for all: after complete lift-off
/// no stress remains.
struct ContactSolution {
  mesh::SkinMesh mesh;
  std::vector<double> cell_lines_x, cell_lines_y; ///< footprint cell edges from its centre [m]
  std::vector<SteppedInstant> stepped;            ///< of one cycle, between which all is linear
  /// Instants at which the slider lands, leaves, sets off, halts or begins to change its load, and
  /// from each begin of sliding to where all of the contact slips its way, to 1 % of the surface's
  /// displacement, or to where the slide ends [s].
  std::vector<double> stepped_events;
  std::vector<std::array<double, 2>> stepped_onsets;
  std::vector<std::string> warnings;
  double worst_complementarity_residual = 0;
  /// Energy that the contact loses in jumps of adhesion, full skin [J].
  double adhesion_loss = 0;
  /// Energy that friction creates, in steps and cells of negative dissipation, full skin [J].
  double created_energy = 0;
  int contact_solves = 0;
};

} // namespace ionskin::mechanics
