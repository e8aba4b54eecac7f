// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/electrochemistry/circuit/sheet_electrodes.hpp"
#include "ionskin/electrochemistry/circuit/terminal_voltage.hpp"
#include "ionskin/electrochemistry/circuit/wall_electrodes.hpp"
#include "ionskin/electrochemistry/equations/ion_flux.hpp"
#include "ionskin/electrochemistry/equations/lateral_flux.hpp"
#include "ionskin/electrochemistry/equations/steric_excess.hpp"
#include "ionskin/electrochemistry/grid/scaled_grid.hpp"
#include "ionskin/electrochemistry/output/ion_state.hpp"
#include "ionskin/parallel/worker_team.hpp"

#include <optional>
#include <span>
#include <vector>

namespace ionskin::electrochemistry {

/// Problem of one implicit stage: find (c, phi) with c = start + step * (rate of change of c), and
/// phi from Poisson's equation. Everything scaled.
struct StageProblem {
  std::span<const double> start;        ///< concentration the stage starts from [nodes]
  double step = 0;                      ///< implicit part of the time step; 0 asks for phi alone
  std::span<const double> fixed_charge; ///< cf / c0 at the instant of the stage [nodes]
  double potential_bottom = 0, potential_top = 0; ///< of the electrodes
  /// Ions in the core: sum over the control volumes of height times concentration.
  double ion_amount = 0;
  /// Replaces `potential_top` by the bottom's potential plus the voltage of the circuit.
  std::optional<CircuitStage> circuit{};
  /// Drives the cations beside the potential [nodes]; empty for none. Must outlive its use.
  std::span<const double> drive{};
  /// Conductors of cut faces behind circuits of their own: the state has their potentials on a cut
  /// wall, and the residual there is the charge of every column plus what has, as its sum over each
  /// conductor, conductance u - start. Must outlive its use.
  const ElectrodeStage* electrodes = nullptr;
  /// Metal with sheet resistances, whose leads have the potentials above or the circuit of its own:
  /// the state has its potentials on both walls, and the residual there is the charge of every
  /// column less what the metal brings it. Must outlive its use.
  const SheetStage* sheets = nullptr;
};

/// Potential of the top electrode: given, or solved from the circuit and the concentrations.
double top_potential(const StageProblem& problem, const TerminalVoltage& voltage,
                     std::span<const double> concentration);

/// The Poisson-Nernst-Planck equations, docs/model.md (12), (13), (14), on finite volumes: the
/// residual of a stage and its exact derivative, applied without forming a matrix. The fluxes are
/// driven by the potential, plus the steric excess and the drive of the stage where there are any.
class TransportEquations {
public:
  /// @param excess nothing for dilute ions
  /// @param electrodes of the faces where they are cut; must outlive this, nullptr otherwise
  /// @param sheets electrodes with sheet resistances; must outlive this, nullptr for none
  TransportEquations(const ScaledGrid& grid, parallel::WorkerTeam& team,
                     std::optional<StericExcess> excess = std::nullopt,
                     const WallElectrodes* electrodes = nullptr,
                     const SheetElectrodes* sheets = nullptr);

  /// Residual of ion balance, then of Poisson's equation, per control volume [2 nodes]. On the
  /// walls the second one is phi minus the electrode's potential.
  void residual(const StageProblem& problem, const IonState& state, std::span<double> out);

  /// Fixes the state about which `apply_jacobian` is taken; the state must outlive its use.
  void linearise(const StageProblem& problem, const IonState& state);

  /// Product out = (derivative of the residual) direction.
  void apply_jacobian(std::span<const double> direction, std::span<double> out);

private:
  /// Work space of one thread, one value per column each.
  struct Workspace {
    explicit Workspace(const ScaledGrid& grid);
    ThicknessFlux thickness_flux;
    LateralFlux lateral_flux;
    std::vector<double> flux_below, flux_above, lateral_ions, lateral_field;
    std::vector<double> drive_change; ///< of one level; used with an excess only
  };

  /// Drive of the fluxes of a state: its potential, or the sum with the excess in `drive`.
  std::span<const double> driving(const StageProblem& problem, const IonState& state,
                                  std::vector<double>& drive);
  /// Adds the contribution of the excess chemical potential to the derivatives of the flux between
  /// the levels `interface` and `interface` + 1.
  void add_excess(std::size_t interface, std::span<const double> concentration);
  /// Residual of the levels from `begin` to before `end`, [2 nodes] in all, into `out`.
  /// @param potential_top of the electrode
  /// @param drive of the fluxes
  void residual_levels(const StageProblem& problem, double potential_top, const IonState& state,
                       std::span<const double> drive, std::size_t begin, std::size_t end,
                       Workspace& work, std::span<double> out) const;
  /// Product of the derivative of the residual with a direction, for the levels from `begin` to
  /// before `end`, into `out`.
  /// @param potential_change of the top electrode
  void jacobian_levels(std::span<const double> direction, double potential_change,
                       std::size_t begin, std::size_t end, Workspace& work,
                       std::span<double> out) const;
  /// Adds the equations of the conductors' circuits to the charges on the walls.
  /// @param potentials of all nodes, or their change
  /// @param from_start whether the charges that the stage starts from count
  void add_circuits(const ElectrodeStage& stage, std::span<const double> potentials,
                    bool from_start, std::span<double> charges) const;
  /// True if the potential of a wall is an unknown of each column.
  bool varies(std::size_t wall, const ElectrodeStage* electrodes, const SheetStage* sheets) const;
  /// Subtracts from the charges on both walls the charge that the metal brings.
  /// @param potentials of all nodes, or their change; of the top lead likewise
  void take_inflow(const SheetStage& stage, std::span<const double> potentials, double lead_bottom,
                   double lead_top, std::span<double> charges) const;
  void flux_change(std::size_t interface, std::span<const double> direction,
                   std::span<double> flux) const;

  const ScaledGrid& grid_;
  parallel::WorkerTeam& team_;
  std::optional<StericExcess> excess_;
  TerminalVoltage voltage_;
  std::vector<Workspace> workspaces_;
  const IonState* state_ = nullptr;
  double step_ = 0;
  std::optional<CircuitStage> circuit_;
  const WallElectrodes* electrodes_;
  const ElectrodeStage* electrode_stage_ = nullptr;
  const SheetElectrodes* sheets_;
  const SheetStage* sheet_stage_ = nullptr;
  std::span<const double> state_drive_;    ///< of the fluxes of `state_`
  std::vector<double> drive_, kept_drive_; ///< of a residual and of `state_`; empty until needed
  std::vector<double> by_lower_, by_upper_, by_difference_; ///< flux derivatives per interface
};

} // namespace ionskin::electrochemistry
