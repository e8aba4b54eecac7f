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

/// Largest residual with which a contact counts as solved, over the largest normal force of a cell
/// [1]; the residual of a prescribed force is included.
inline constexpr double contact_tolerance = 1e-9;

/// Small strain in the core at points on a tensor grid: in each box between the lines of the mesh,
/// at both Gauss points of its height, averaged over each of the four quarters of its plan. In half
/// models the grid covers only y <= width / 2.
struct CoreStrain {
  std::array<std::size_t, 3> points{}; ///< number of points along x, y, z
  /// Tensor components xx, yy, zz, yz, xz, xy, each [z][y][x] with x fastest; empty for a component
  /// that the case does not read [1].
  std::array<std::vector<double>, 6> component;
};

/// Small strain in the core and in the electrodes of a skin.
struct LayerStrain {
  CoreStrain core;
  /// Strain of the electrode layers, from bottom to top in place of z: averaged through their
  /// thickness and over each column between the lines of the mesh.
  CoreStrain electrodes;
};

/// Recovers the strain of all layers in one state of a path.
/// @param place index of the state in its `StrainSource`
using LayerStrainAt = std::function<LayerStrain(std::size_t place)>;

/// Strains of the states of a path, recovered on demand, because the strains of a long path would
/// fill the memory.
class StrainSource {
public:
  virtual ~StrainSource() = default;
  /// Strain of the core in a state; valid until the next call. Fast when indices ascend.
  /// @param place index of the state, `ContactState::place`
  virtual const CoreStrain& at(std::size_t place) = 0;
  /// Prepares the strains of all layers, once for all states. The source must outlive the result.
  /// References that `at` returned stay valid.
  virtual LayerStrainAt all_layers() const = 0;
  /// Largest von Mises stress in each electrode layer, bottom to top, over all states recovered so
  /// far [Pa]. The stress is that of a membrane: averaged through the layer and over each column of
  /// elements.
  virtual const std::vector<double>& largest_electrode_stress() const = 0;
  /// Largest difference between the forces on the cells and the forces through a level of the core,
  /// relative to the forces on the cells, over all states recovered so far [1].
  virtual double worst_equilibrium_residual() const = 0;
};

/// Converged equilibrium of slider and skin at one instant. Forces, areas and energies are those of
/// the full skin.
struct ContactState {
  double indentation = 0;  ///< of the slider's lowest point below the undeformed top face [m]
  double normal_force = 0; ///< on the full skin, compression positive [N]
  std::array<double, 2> tangential_force{}; ///< of the slider on the full skin, along x and y [N]
  /// Moment of the slider's forces on the full skin about x, y and z through the slider's centre on
  /// the undeformed top face, docs/model.md (79) [N m].
  std::array<double, 3> moment{};
  /// Normal traction of each contact cell, compression positive, [y][x] with x fastest [Pa]. In
  /// half models this vector and all others here cover only y <= width / 2.
  std::vector<double> normal_traction;
  /// Traction of the slider on the skin along x, in each contact cell, [y][x] [Pa].
  std::vector<double> tangential_traction_x;
  /// Traction of the slider on the skin along y, in each contact cell, [y][x] [Pa].
  std::vector<double> tangential_traction_y;
  /// Mean displacement of the skin in each contact cell: normal (downwards), along x, along y,
  /// [y][x][3] [m].
  std::vector<double> surface;
  /// Length of the slip of each contact cell since the state before on the path, apart from elastic
  /// slip, [y][x] [m].
  std::vector<double> slip;
  CoreStrain strain;                    ///< strain of the core; empty where `source` recovers it
  std::shared_ptr<StrainSource> source; ///< recovers the strain; null where `strain` holds it
  std::size_t place = 0;                ///< index of this state in `source`
  /// Tangential traction that each contact cell can still take before it slips, [y][x]; 0 where the
  /// cell slips or does not touch [Pa].
  std::vector<double> stick_reserve;
  double contact_area = 0; ///< of the full skin, see `contact_area` in covered_area.hpp [m2]
  double stick_area = 0;   ///< part of the contact area where nothing slips [m2]
  /// Uncertainty of the contact area and of the stick area, because whole cells either belong to
  /// them or not, see `border_area` [m2].
  double contact_border = 0, stick_border = 0;
  double binding_energy = 0;  ///< of adhesion, on the full skin [J]
  double friction_energy = 0; ///< stored in the elastic slip of friction, full skin [J]
  // diagnostics
  /// Largest violation of the conditions of contact and friction, relative, see
  /// `contact_violations` [1].
  double complementarity_residual = 0;
  double stick_fraction = 0; ///< area of sticking cells over area of touching cells [1]
  int iterations = 0;        ///< of Newton's method
};

/// Strain of the core in a state, stored or recovered; a recovered one is valid until the next
/// call.
inline const CoreStrain& core_strain(const ContactState& state) {
  return state.source ? state.source->at(state.place) : state.strain;
}

using SharedState = std::shared_ptr<const ContactState>;

/// Instant of the slider's motion, with the state of the contact.
struct SteppedInstant {
  double time = 0;                     ///< since the begin of the cycle [s]
  std::array<double, 2> centre{};      ///< of the slider [m]
  double height = 0;                   ///< of its underside above the undeformed top face [m]
  SharedState state;                   ///< null while the slider is off the skin
  std::array<double, 2> drive_force{}; ///< of a drive on the slider; 0 off the skin [N]
  /// Displacement of the slider's underside at each contact cell by its tilt and turn: normal
  /// (downwards), along x, along y [m]. Only differences between instants count. Null where the
  /// slider's angles never change.
  std::shared_ptr<const std::vector<std::array<double, 3>>> turned = {};
};

/// Result of Study 1 for one friction coefficient. It covers one cycle, which stands for all
/// cycles, since no stress remains after complete lift-off.
struct ContactSolution {
  mesh::SkinMesh mesh;
  /// Edges of the contact cells from the slider's centre [m].
  std::vector<double> cell_lines_x, cell_lines_y;
  std::vector<SteppedInstant> stepped; ///< instants of one cycle; all is linear between them
  /// Instants at which the slider lands, leaves, sets off, halts or begins to change its load [s].
  std::vector<double> stepped_events;
  /// Begin and end of each onset of sliding [s]: it ends where the whole contact slips and the mean
  /// displacement of the surface is within 1 % of its value in full slip, or where the slide ends.
  std::vector<std::array<double, 2>> stepped_onsets;
  std::vector<std::string> warnings; ///< for the user, as whole sentences
  /// Largest `ContactState::complementarity_residual` over all steps of the path, stored or not
  /// [1].
  double worst_complementarity_residual = 0;
  /// Energy that the contact loses where adhesion makes it jump, on the full skin [J].
  double adhesion_loss = 0;
  /// Energy that friction creates in steps and cells of negative dissipation, a measure of error,
  /// on the full skin [J].
  double created_energy = 0;
  int contact_solves = 0; ///< number of contact steps taken
};

} // namespace ionskin::mechanics
