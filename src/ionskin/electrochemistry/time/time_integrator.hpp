// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/electrochemistry/equations/space_charge.hpp"
#include "ionskin/electrochemistry/grid/derived_scales.hpp"
#include "ionskin/electrochemistry/output/electrode_potentials.hpp"
#include "ionskin/electrochemistry/output/ion_state.hpp"
#include "ionskin/electrochemistry/solver/charge_norm.hpp"
#include "ionskin/electrochemistry/solver/newton_krylov.hpp"
#include "ionskin/electrochemistry/time/electrode_charges.hpp"

#include <optional>
#include <vector>

namespace ionskin::electrochemistry {

/// Time integrator of Study 2: TR-BDF2 as a diagonally implicit Runge-Kutta method, see
/// `tr_bdf2.hpp`. It is of order 2, L-stable and stiffly accurate, so that double layers faster
/// than a step do not oscillate and Poisson's equation holds at the end of every step. Both
/// implicit stages have the same implicit part of the step, and the embedded formula of order 3
/// estimates the error (Bank et al. 1985, IEEE Transactions on Electron Devices 32, 1992). Ions
/// that the coupling law releases enter exactly: the method advances concentration minus released
/// ions.
class TimeIntegrator {
public:
  /// @param grid must outlive this, as must all other references
  /// @param potentials given potentials of the electrodes, or of their leads
  TimeIntegrator(const ScaledGrid& grid, const DerivedScales& scales, FixedCharge& fixed_charge,
                 ElectrodePotentials potentials, ElectrodeCharges& electrodes, NewtonKrylov& solver,
                 parallel::WorkerTeam& team);

  /// Computes the state at the first instant [s]: ions where they were at rest, phi from Poisson's
  /// equation. Throws SolverError when that has no solution.
  void initialise(double time, TransportState& state);
  /// Resumes from a state that a run has left at an instant [s].
  void take_up(double time, TransportState& state);
  /// Computes potentials and rates anew where circuits have changed at an instant [s], see
  /// `ConductorCharges::reconnect`. Throws SolverError when Poisson's equation has no solution.
  void restart(double time, TransportState& state);

  /// Tries the time step from `begin`, the instant of `state`, to `end` [s], and leaves
  /// `fixed_charge` evaluated at `end`.
  /// @param column_share weight of the errors of single columns, see `ChargeNorm::of_change` [1]
  /// @returns the estimated error of the charge, over the largest charge so far [1]; nothing where
  ///   Newton's method found no solution
  std::optional<double> try_step(double begin, double end, const TransportState& state,
                                 double column_share);
  /// Accepts the end of the step that was tried last as the new state.
  void accept(TransportState& state);

  /// Reads the electrodes in the state that was accepted or resumed last.
  ElectrodeReading reading(const TransportState& state) const {
    return electrodes_.reading(settled_, state);
  }

private:
  /// Calls `body(node, released)` for every node, with the ions released there until the instant
  /// evaluated last.
  template <class Body> void for_nodes(const Body& body) const;
  /// Makes the problem of the stage at an instant [s]: evaluates charges and potentials given
  /// there, and adds the ions released until then to `start_`.
  StageProblem problem_at(double time);
  /// Solves Poisson's equation for the potential of a state; returns false when there is no
  /// solution.
  bool find_potential(const StageProblem& problem, TransportState& state);
  /// Takes a state as the begin of the next step, and notes what the next step needs of it.
  void settle(TransportState& state);
  /// Guesses the solution of the middle stage from the begin of the step along its rate.
  void guess_middle(const TransportState& state);
  /// Guesses the solution at the end of the step: concentrations on the parabola through begin and
  /// middle stage with the rate at the begin; potentials, whose rate jumps at kinks of the shear,
  /// on the straight line.
  void guess_end(const TransportState& state);
  /// Replaces a guess by `safe` where it would deplete a concentration or the free share of the
  /// sites beside it.
  void keep_in_bounds(const IonState& safe, IonState& guess) const;
  /// Estimates the error of the charge in the step, over the largest charge so far [1].
  double step_error(const TransportState& state, double column_share);

  const ScaledGrid& grid_;
  const DerivedScales& scales_;
  FixedCharge& fixed_charge_;
  ElectrodePotentials potentials_;
  ElectrodeCharges& electrodes_;
  NewtonKrylov& solver_;
  parallel::WorkerTeam& team_;
  ChargeNorm charge_norm_;
  double resting_amount_;       ///< amount of ions in the core at rest, scaled
  double length_ = 0;           ///< length of the current step [relaxation times]
  double implicit_ = 0;         ///< implicit part of the step [relaxation times]
  std::vector<double> settled_; ///< concentration minus released ions where the step begins
  std::vector<double> start_;   ///< concentration a stage starts from; its error after the step
  std::vector<double> middle_rate_, end_rate_; ///< of concentration minus released ions
  IonState middle_, end_;
};

} // namespace ionskin::electrochemistry
