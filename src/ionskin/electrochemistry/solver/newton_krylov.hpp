// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/electrochemistry/equations/exact_average.hpp"
#include "ionskin/electrochemistry/equations/transport_equations.hpp"
#include "ionskin/electrochemistry/solver/closed_preconditioner.hpp"
#include "ionskin/electrochemistry/solver/gmres.hpp"
#include "ionskin/parallel/vector_operations.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace ionskin::electrochemistry {

/// Counters of the work of the nonlinear solver so far.
struct SolverCounters {
  std::size_t residual_evaluations = 0, krylov_iterations = 0, preconditioner_setups = 0;
};

/// Solver of one implicit stage: simplified Newton's method, whose matrix is the preconditioner, as
/// long as that contracts fast, and else Newton's method with GMRES for the corrections. Residuals
/// are measured after preconditioning, that is as errors of the scaled unknowns. A step must reduce
/// the residual (natural monotonicity test: Deuflhard 2011, doi 10.1007/978-3-642-23899-4). Where
/// it would take away more than 90 % of a concentration, or with a steric excess of the free share
/// of the sites, that concentration's own step is shortened. c stays within its bounds on the way,
/// and an accepted solution satisfies the equations.
class NewtonKrylov {
public:
  /// @param grid must outlive this, as must `team`
  /// @param tolerance error allowed in the unknowns, over the largest departure from the state at
  ///   rest [1]
  /// @param excess steric excess; nothing for dilute ions
  /// @param electrodes conductors of cut faces; must outlive this; nullptr where no face is cut
  /// @param sheets electrodes with sheet resistances; must outlive this; nullptr for none
  NewtonKrylov(const ScaledGrid& grid, double tolerance, parallel::WorkerTeam& team,
               std::optional<StericExcess> excess = std::nullopt,
               const WallElectrodes* electrodes = nullptr, const SheetElectrodes* sheets = nullptr);

  /// Factorises the preconditioner anew for stages near a state.
  /// @param step implicit part of the time step [relaxation times]
  void prepare(const IonState& state, double step);

  /// Solves a stage from the guess in `state`, whose concentrations must be within their bounds;
  /// the solution replaces it.
  /// @returns false when Newton's method gives up; `state` is then of no use
  bool solve(const StageProblem& problem, IonState& state);

  /// Computes the rate of change of the concentrations by transport [c0/v per relaxation time],
  /// [nodes], at a state that satisfies Poisson's equation.
  void rate(const StageProblem& problem, const IonState& state, std::span<double> out);

  /// Damps the modes that are faster than the step in a change of the concentrations [nodes], as
  /// one implicit Euler step of the prepared length does.
  /// @returns sums of the damped change over the levels, [weight][y][x]
  std::array<std::vector<double>, 2>
  damped_sums(std::span<const double> change, const std::array<std::vector<double>, 2>& weights) {
    return preconditioner_.damped_sums(change, weights);
  }

  /// Damps a change of the concentrations [nodes] as `damped_sums` does, together with the charges
  /// of metal that has a sheet resistance.
  /// @param charges per area brought to the columns, [bottom, top][y][x]
  /// @returns charges that are left on the columns, [bottom, top][y][x]
  std::array<std::vector<double>, 2>
  damped_charges(std::span<const double> change, const std::array<std::vector<double>, 2>& charges);

  /// Steric excess; nothing for dilute ions.
  const std::optional<StericExcess>& excess() const { return excess_; }

  const SolverCounters& counters() const { return counters_; }
  void restore_counters(const SolverCounters& counters) { counters_ = counters; }

private:
  double precondition_residual(const StageProblem& problem, const IonState& state);
  double allowed_error(const StageProblem& problem, const IonState& state);
  void step(const IonState& state, double length, std::span<const double> correction,
            IonState& out);
  /// Applies simplified Newton's method, starting from the defect of `state`; returns true if
  /// `state` then solves the stage.
  bool correct_by_defects(const StageProblem& problem, IonState& state, double allowed);
  void finish(const StageProblem& problem, IonState& state);
  bool search(const StageProblem& problem, IonState& state);
  /// Solves for `correction_` by GMRES; returns the number of Krylov iterations.
  int solve_linearised(const StageProblem& problem, const IonState& state, double reduction);

  const ScaledGrid& grid_;
  double tolerance_;
  std::optional<StericExcess> excess_;
  parallel::WorkerTeam& team_;
  parallel::VectorOperations vectors_;
  TransportEquations equations_;
  ClosedPreconditioner preconditioner_;
  Gmres gmres_;
  ExactAverage exact_average_;
  SolverCounters counters_;
  IonState trial_;
  std::vector<double> residual_;   ///< of the equations
  std::vector<double> defect_;     ///< preconditioned residual: the estimated error of the state
  std::vector<double> correction_; ///< solves (preconditioned Jacobian) correction = defect
};

} // namespace ionskin::electrochemistry
