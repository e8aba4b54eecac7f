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

/// Counters of the solver's work so far.
struct SolverCounters {
  std::size_t residual_evaluations = 0, krylov_iterations = 0, preconditioner_setups = 0;
};

/// Solves one implicit stage by simplified Newton's method, whose matrix is the preconditioner, as
/// long as that contracts fast, and else by Newton's method with GMRES for the corrections.
/// Residuals are measured after preconditioning, that is as errors of the scaled unknowns. A step
/// must reduce the residual (natural monotonicity test: Deuflhard 2011,
/// doi 10.1007/978-3-642-23899-4), and where it would take away more than 90 % of a concentration,
/// that concentration's own step is shortened; so it is, with a steric excess, where it would take
/// more than 90 % of the room that is left. c stays within its bounds on the way, and what is
/// accepted satisfies the equations.
class NewtonKrylov {
public:
  /// @param tolerance error allowed in the unknowns, against the largest departure from the state
  ///   at rest
  /// @param excess nothing for dilute ions
  /// @param electrodes of the faces where they are cut; must outlive this, nullptr otherwise
  /// @param sheets electrodes with sheet resistances; must outlive this, nullptr for none
  NewtonKrylov(const ScaledGrid& grid, double tolerance, parallel::WorkerTeam& team,
               std::optional<StericExcess> excess = std::nullopt,
               const WallElectrodes* electrodes = nullptr, const SheetElectrodes* sheets = nullptr);

  /// Renews the preconditioner for stages with this implicit step near this state.
  void prepare(const IonState& state, double step);

  /// Replaces the guess in `state`, whose concentrations must be within their bounds, by the
  /// solution.
  /// @returns false when Newton's method gives up; `state` is then of no use
  bool solve(const StageProblem& problem, IonState& state);

  /// Rate of change of the concentrations by transport at a state that satisfies Poisson's equation
  /// [nodes].
  void rate(const StageProblem& problem, const IonState& state, std::span<double> out);

  /// Damps the modes that are faster than the step in a change of the concentrations [nodes], as
  /// one implicit Euler step of the prepared length does.
  /// @returns sums of the damped change over the levels, with weights [levels] each: two per column
  std::array<std::vector<double>, 2>
  damped_sums(std::span<const double> change, const std::array<std::vector<double>, 2>& weights) {
    return preconditioner_.damped_sums(change, weights);
  }

  /// Damps a change of the concentrations [nodes] as `damped_sums` does, and the charges of metal
  /// that has a sheet resistance with it.
  /// @param charges per area brought to the columns of the bottom and of the top wall
  /// @returns charges that are left on them
  std::array<std::vector<double>, 2>
  damped_charges(std::span<const double> change, const std::array<std::vector<double>, 2>& charges);

  /// Nothing for dilute ions.
  const std::optional<StericExcess>& excess() const { return excess_; }

  const SolverCounters& counters() const { return counters_; }
  void restore_counters(const SolverCounters& counters) { counters_ = counters; }

private:
  double precondition_residual(const StageProblem& problem, const IonState& state);
  double allowed_error(const StageProblem& problem, const IonState& state);
  void step(const IonState& state, double length, std::span<const double> correction,
            IonState& out);
  /// Simplified Newton's method from the state's defect on; `state` solves the stage when true.
  bool correct_by_defects(const StageProblem& problem, IonState& state, double allowed);
  void finish(const StageProblem& problem, IonState& state);
  bool search(const StageProblem& problem, IonState& state);
  /// Sets the correction; returns the number of Krylov iterations.
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
