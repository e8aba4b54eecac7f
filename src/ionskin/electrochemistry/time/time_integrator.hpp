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

/// A conductor of a cut face at an instant, scaled: its potential, the charge on its metal, and
/// the part of it that its circuit has passed or holds.
struct ElectrodeRow {
  double potential = 0, charge = 0, passed = 0;
};

/// Part of the charge that changes smoothly at kinks of the shear, see IonSolution, and its rate;
/// per area and scaled.
struct Relaxation {
  double charge = 0, rate = 0;
};

/// TR-BDF2 as a diagonally implicit Runge-Kutta method with an explicit first stage: of order 2,
/// L-stable and stiffly accurate, so that double layers faster than a step stay quiet and Poisson's
/// equation holds at the end of every step; both implicit stages have the same implicit part of the
/// step, and the embedded formula of order 3 estimates the error (Bank et al. 1985, IEEE
/// Transactions on Electron Devices 32, 1992; Hosea and Shampine 1996, Applied Numerical
/// Mathematics 20, 21). Ions that the coupling law releases enter exactly: the method advances
/// concentration minus released ions.
class TimeIntegrator {
public:
  /// @param admittance of the circuit between the electrodes; without it the potentials are given
  /// @param electrodes of the faces where they are cut, instead; those of the solver
  /// @param sheets electrodes with sheet resistances and their circuit, instead; those of the
  /// solver
  TimeIntegrator(const ScaledGrid& grid, const DerivedScales& scales, FixedCharge& fixed_charge,
                 ElectrodePotentials potentials, NewtonKrylov& solver, parallel::WorkerTeam& team,
                 std::optional<ScaledAdmittance> admittance = std::nullopt,
                 const WallElectrodes* electrodes = nullptr,
                 const SheetElectrodes* sheets = nullptr);

  /// The response at the first instant: ions where they were, phi from Poisson's equation.
  /// Throws SolverError.
  void initialise(double time, TransportState& state);
  /// Takes up a state that a run has left at an instant.
  void take_up(double time, const TransportState& state);

  /// Joins the conductors of cut faces to these circuits from now on, before the first instant
  /// or where a run is taken up.
  void connect(std::vector<std::optional<ScaledAdmittance>> circuits);
  /// Does so at an instant of a run, where the state stands: conductors that come to the ground
  /// give up their voltage, capacitors of new circuits are uncharged. Throws SolverError.
  void reconnect(double time, std::vector<std::optional<ScaledAdmittance>> circuits,
                 TransportState& state);

  /// Tries the step from `begin`, where the state stands, to `end` [s], and leaves the fixed charge
  /// at `end`.
  /// @param column_share of the errors of single columns, see `ChargeNorm::of_change`
  /// @returns the estimated error of the charge, over the largest charge so far; nothing where
  ///   Newton's method found no solution
  std::optional<double> try_step(double begin, double end, const TransportState& state,
                                 double column_share);
  /// Makes the end of the step tried last the new state.
  void accept(TransportState& state);

  /// Rows of the conductors of cut faces, in the state that was accepted or taken up last;
  /// empty for one conductor on each face.
  std::vector<ElectrodeRow> electrode_rows(const TransportState& state) const;

  /// Voltage between the leads of metal with sheet resistances; nothing without.
  std::optional<double> lead_voltage(const TransportState& state) const;

  /// Relaxation of the state that was accepted or taken up last.
  Relaxation relaxation(const TransportState& state) const;

private:
  void note_charge(TransportState& state);
  double voltage(const IonState& ions) const;
  std::vector<double> potentials(const IonState& ions) const;
  /// Half of the net charge below every column, and below every conductor, that the law has made
  /// until the instant evaluated last.
  std::vector<double> net_of_columns() const;
  std::vector<double> net_charges() const;
  /// Area of a conductor, in columns.
  double area(std::size_t conductor) const;
  /// The largest of some charges of conductors, per area.
  double largest_of_conductors(const std::vector<double>& charges) const;
  /// Rate of the conserved charge: that which the circuit's resistor passes.
  double charge_rate(const IonState& ions) const;
  /// Keeps the concentration that a step starts from, without the released ions.
  void settle(const IonState& ions);
  /// Calls `body(node, released)` for every node, with the ions released there so far.
  template <class Body> void for_nodes(const Body& body) const;
  StageProblem problem_at(double time);
  void guess_stage(const TransportState& state);
  void guess_end(const TransportState& state);
  /// Keeps the rounding errors of the potentials of conductors, at the ground or of one column
  /// beside another, from growing step by step.
  void restore_conductors(IonState& guess) const;
  /// Takes `safe` instead of a guess that would deplete a concentration or the room beside it.
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
  double resting_amount_;       ///< ions in the core at rest, scaled
  double length_ = 0;           ///< of the step at hand [relaxation times]
  double implicit_ = 0;         ///< implicit part of the step
  std::vector<double> settled_; ///< concentration minus released ions where the step begins
  std::vector<double> start_;   ///< concentration a stage starts from
  /// Half the difference of the electrodes' charges and the charge on the circuit's capacitor,
  /// which are conserved together, where the step begins.
  double settled_charge_ = 0;
  double start_charge_ = 0;                    ///< the same that a stage starts from
  std::optional<ElectrodeCharges> electrodes_; ///< of cut faces
  ElectrodeStage electrode_stage_;
  std::optional<SheetCharges> sheets_; ///< of metal with sheet resistances
  SheetStage sheet_stage_;
  std::vector<double> start_charges_, end_charges_; ///< of its conductors
  std::vector<double> stage_rate_, end_rate_;       ///< of concentration minus released ions
  IonState stage_, end_;
};

} // namespace ionskin::electrochemistry
