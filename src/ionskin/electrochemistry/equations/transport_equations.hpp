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

/// Problem of one implicit stage of a time step: find (c, phi) such that c = start + step * (rate
/// of change of c) and phi solves Poisson's equation. All values are scaled.
struct StageProblem {
  std::span<const double> start;        ///< concentration from which the stage starts [nodes]
  double step = 0;                      ///< implicit part of the time step; 0 asks for phi only
  std::span<const double> fixed_charge; ///< cf / c0 at the instant of the stage [nodes]
  /// Potentials of the electrodes, or of their leads [R T/(v F)].
  double potential_bottom = 0, potential_top = 0;
  /// Known amount of ions in the core: sum over the control volumes of height times concentration.
  double ion_amount = 0;
  /// Circuit between the electrodes, which makes the top potential `potential_bottom` plus its
  /// voltage in the place of `potential_top`; nothing where `potential_top` is given.
  std::optional<CircuitStage> circuit{};
  /// Drive of the cations beside the potential [nodes]; empty for none. Must outlive its use.
  std::span<const double> drive{};
  /// Conductors of cut faces behind circuits of their own; nullptr for none. On a cut wall the
  /// unknowns are the potentials of the columns. The residual there is the charge of every column
  /// plus a field whose sum over each conductor is conductance u - start. Must outlive its use.
  const ElectrodeStage* electrodes = nullptr;
  /// Metal with sheet resistances; nullptr for none. Its leads have the potentials above, or
  /// `SheetStage::circuit`. The unknowns on both walls are the potentials of the columns, and the
  /// residual there is the charge of every column less the charge that the metal brings. Must
  /// outlive its use.
  const SheetStage* sheets = nullptr;
};

/// Potential of the top electrode [R T/(v F)]: as given, or as the circuit and the concentrations
/// [nodes] determine it.
double top_potential(const StageProblem& problem, const TerminalVoltage& voltage,
                     std::span<const double> concentration);

/// Poisson-Nernst-Planck equations, docs/model.md (12), (13), (14), on finite volumes: the residual
/// of a stage and the exact product of its derivative with a vector, without a matrix. The
/// potential drives the fluxes, together with the steric excess and the drive of the stage where
/// there are any.
class TransportEquations {
public:
  /// @param grid must outlive this, as must `team`
  /// @param excess steric excess; nothing for dilute ions
  /// @param electrodes conductors of cut faces; must outlive this; nullptr where no face is cut
  /// @param sheets electrodes with sheet resistances; must outlive this; nullptr for none
  TransportEquations(const ScaledGrid& grid, parallel::WorkerTeam& team,
                     std::optional<StericExcess> excess = std::nullopt,
                     const WallElectrodes* electrodes = nullptr,
                     const SheetElectrodes* sheets = nullptr);

  /// Computes the residual of the ion balance, then of Poisson's equation, per control volume [2
  /// nodes]. On a wall with a given potential the second is phi minus that potential; for other
  /// walls see `StageProblem`.
  void residual(const StageProblem& problem, const IonState& state, std::span<double> out);

  /// Sets the state at which `apply_jacobian` takes the derivative; `state` and the members of
  /// `problem` must outlive its use.
  void linearise(const StageProblem& problem, const IonState& state);

  /// Computes out = (derivative of the residual) direction; both [2 nodes].
  void apply_jacobian(std::span<const double> direction, std::span<double> out);

private:
  /// Work space of one thread; the vectors hold one value per column.
  struct Workspace {
    explicit Workspace(const ScaledGrid& grid);
    ThicknessFlux thickness_flux;
    LateralFlux lateral_flux;
    std::vector<double> flux_below, flux_above, lateral_ions, lateral_field;
    std::vector<double> drive_change; ///< of one level; used with an excess only
  };

  /// Potential that drives the fluxes of a state [nodes]: its own, or the sum with excess and
  /// drive, which `drive` receives.
  std::span<const double> driving(const StageProblem& problem, const IonState& state,
                                  std::vector<double>& drive);
  /// Adds the contribution of the excess chemical potential to the derivatives of the flux between
  /// the z levels `interface` and `interface` + 1.
  void add_excess(std::size_t interface, std::span<const double> concentration);
  /// Computes the residual of the z levels from `begin` to before `end` into `out` [2 nodes].
  /// @param potential_top of the top electrode
  /// @param drive potential that drives the fluxes [nodes]
  void residual_levels(const StageProblem& problem, double potential_top, const IonState& state,
                       std::span<const double> drive, std::size_t begin, std::size_t end,
                       Workspace& work, std::span<double> out) const;
  /// Computes the product of the derivative of the residual with a direction, for the z levels from
  /// `begin` to before `end`, into `out` [2 nodes].
  /// @param potential_change of the top electrode
  void jacobian_levels(std::span<const double> direction, double potential_change,
                       std::size_t begin, std::size_t end, Workspace& work,
                       std::span<double> out) const;
  /// Adds the equations of the conductors' circuits to the charges on the walls.
  /// @param potentials of all nodes, or their change
  /// @param from_start true if the charges that the stage starts from count
  void add_circuits(const ElectrodeStage& stage, std::span<const double> potentials,
                    bool from_start, std::span<double> charges) const;
  /// True if the potential of a wall is an unknown of each column.
  bool varies(std::size_t wall, const ElectrodeStage* electrodes, const SheetStage* sheets) const;
  /// Subtracts from the charges on both walls the charge that the metal brings.
  /// @param potentials of all nodes, or their change
  /// @param lead_bottom, lead_top potentials of the leads, or their change
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
  std::span<const double> state_drive_;    ///< potential that drives the fluxes of `state_`
  std::vector<double> drive_, kept_drive_; ///< for a residual and for `state_`; empty until needed
  std::vector<double> by_lower_, by_upper_, by_difference_; ///< flux derivatives per interface
};

} // namespace ionskin::electrochemistry
