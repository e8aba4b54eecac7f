// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/electrochemistry/circuit/electrode_charges.hpp"
#include "ionskin/electrochemistry/circuit/external_circuit.hpp"
#include "ionskin/electrochemistry/circuit/sheet_charges.hpp"
#include "ionskin/electrochemistry/equations/space_charge.hpp"
#include "ionskin/electrochemistry/grid/derived_scales.hpp"
#include "ionskin/electrochemistry/output/electrode_potentials.hpp"
#include "ionskin/electrochemistry/output/ion_state.hpp"
#include "ionskin/electrochemistry/solver/charge_norm.hpp"
#include "ionskin/electrochemistry/solver/newton_krylov.hpp"

#include <optional>
#include <vector>

namespace ionskin::electrochemistry {

/// State of a conductor of a cut face at an instant: its potential [R T/(v F)], the charge on its
/// metal, and the part of that which its circuit has passed or holds [F c0 lambda times the area of
/// a column].
struct ElectrodeRow {
  double potential = 0, charge = 0, passed = 0;
};

/// Part of (Q_top - Q_bottom)/2 that changes smoothly at kinks of the shear, see
/// `IonSolution::relaxation_charge`, and its rate; per area, scaled.
struct Relaxation {
  double charge = 0, rate = 0;
};

/// Time integrator of Study 2: TR-BDF2 as a diagonally implicit Runge-Kutta method with an explicit
/// first stage. It is of order 2, L-stable and stiffly accurate, so that double layers faster than
/// a step do not oscillate and Poisson's equation holds at the end of every step. Both implicit
/// stages have the same implicit part of the step, and the embedded formula of order 3 estimates
/// the error (Bank et al. 1985, IEEE Transactions on Electron Devices 32, 1992; Hosea and Shampine
/// 1996, Applied Numerical Mathematics 20, 21). Ions that the coupling law releases enter exactly:
/// the method advances concentration minus released ions.
class TimeIntegrator {
public:
  /// @param grid must outlive this, as must `fixed_charge`, `solver` and `team`
  /// @param potentials given potentials of the electrodes, or of their leads
  /// @param admittance scaled circuit between the electrodes; nothing where their potentials are
  ///   given
  /// @param electrodes conductors of cut faces, instead of `admittance`; as given to the solver;
  ///   nullptr for none
  /// @param sheets electrodes with sheet resistances and their circuit, instead of `admittance`; as
  ///   given to the solver; nullptr for none
  TimeIntegrator(const ScaledGrid& grid, const DerivedScales& scales, FixedCharge& fixed_charge,
                 ElectrodePotentials potentials, NewtonKrylov& solver, parallel::WorkerTeam& team,
                 std::optional<ScaledAdmittance> admittance = std::nullopt,
                 const WallElectrodes* electrodes = nullptr,
                 const SheetElectrodes* sheets = nullptr);

  /// Computes the state at the first instant [s]: ions where they were at rest, phi from Poisson's
  /// equation. Throws SolverError when that has no solution.
  void initialise(double time, TransportState& state);
  /// Resumes from a state that a run has left at an instant [s].
  void take_up(double time, const TransportState& state);

  /// Connects the conductors of cut faces to circuits, one entry each, from now on: before the
  /// first instant or where a run is resumed. An empty entry holds a conductor at the ground.
  void connect(std::vector<std::optional<ScaledAdmittance>> circuits);
  /// Changes the circuits of the conductors at an instant of a run [s], at which `state` is:
  /// conductors that come to the ground give up their voltage, capacitors of new circuits are
  /// uncharged. Throws SolverError when Poisson's equation then has no solution.
  void reconnect(double time, std::vector<std::optional<ScaledAdmittance>> circuits,
                 TransportState& state);

  /// Tries the time step from `begin`, the instant of `state`, to `end` [s], and leaves
  /// `fixed_charge` evaluated at `end`.
  /// @param column_share weight of the errors of single columns, see `ChargeNorm::of_change` [1]
  /// @returns the estimated error of the charge, over the largest charge so far [1]; nothing where
  ///   Newton's method found no solution
  std::optional<double> try_step(double begin, double end, const TransportState& state,
                                 double column_share);
  /// Accepts the end of the step that was tried last as the new state.
  void accept(TransportState& state);

  /// Rows of the conductors of cut faces, in the state that was accepted or resumed last; empty
  /// where each face has one potential.
  std::vector<ElectrodeRow> electrode_rows(const TransportState& state) const;

  /// Voltage between the leads of metal with sheet resistances [R T/(v F)]; nothing without.
  std::optional<double> lead_voltage(const TransportState& state) const;

  /// Smooth part of the charge in the state that was accepted or resumed last; 0 for conductors of
  /// cut faces.
  Relaxation relaxation(const TransportState& state) const;

private:
  void note_charge(TransportState& state);
  double voltage(const IonState& ions) const;
  std::vector<double> potentials(const IonState& ions) const;
  /// Half of the net charge per area below every column, and on every conductor, that the law has
  /// made until the instant evaluated last.
  std::vector<double> net_of_columns() const;
  std::vector<double> net_charges() const;
  /// Area of a conductor, in columns.
  double area(std::size_t conductor) const;
  /// Largest magnitude of charges of the conductors, per area.
  double largest_of_conductors(const std::vector<double>& charges) const;
  /// Rate of the conserved charge q + C U: the current through the circuit's resistor.
  double charge_rate(const IonState& ions) const;
  /// Stores the concentration without released ions, and the conserved charge, from which a step
  /// starts.
  void settle(const IonState& ions);
  /// Calls `body(node, released)` for every node, with the ions released there so far.
  template <class Body> void for_nodes(const Body& body) const;
  StageProblem problem_at(double time);
  void guess_stage(const TransportState& state);
  void guess_end(const TransportState& state);
  /// Prevents rounding errors in the potentials of conductors, at the ground or of one column
  /// beside another, from growing step by step.
  void restore_conductors(IonState& guess) const;
  /// Replaces a guess by `safe` where it would deplete a concentration or the free share of the
  /// sites beside it.
  void keep_in_bounds(const IonState& safe, IonState& guess) const;
  double charge_error(const TransportState& state, double column_share,
                      double passed_by_conductors);

  const ScaledGrid& grid_;
  DerivedScales scales_;
  FixedCharge& fixed_charge_;
  ElectrodePotentials potentials_;
  NewtonKrylov& solver_;
  parallel::WorkerTeam& team_;
  std::optional<ScaledAdmittance> admittance_;
  TerminalVoltage terminals_;
  ChargeNorm charge_norm_;
  double resting_amount_;       ///< amount of ions in the core at rest, scaled
  double length_ = 0;           ///< length of the current step [relaxation times]
  double implicit_ = 0;         ///< implicit part of the step
  std::vector<double> settled_; ///< concentration minus released ions where the step begins
  std::vector<double> start_;   ///< concentration a stage starts from
  /// Half of the difference of the electrodes' charges, plus the charge on the circuit's capacitor,
  /// where the step begins; both are conserved together.
  double settled_charge_ = 0;
  /// Conserved charge from which a stage starts, as `settled_charge_`.
  double start_charge_ = 0;
  std::optional<ElectrodeCharges> electrodes_; ///< of cut faces
  ElectrodeStage electrode_stage_;
  std::optional<SheetCharges> sheets_; ///< of metal with sheet resistances
  SheetStage sheet_stage_;
  std::vector<double> start_charges_, end_charges_; ///< of its conductors
  std::vector<double> stage_rate_, end_rate_;       ///< of concentration minus released ions
  IonState stage_, end_;
};

} // namespace ionskin::electrochemistry
