// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/time/time_integrator.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/base/largest.hpp"
#include "ionskin/electrochemistry/time/tr_bdf2.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <utility>

namespace ionskin::electrochemistry {

using tr_bdf2::stage_fraction;

namespace {

/// Rounding error of a concentration, which counts in the charge of a core of many Debye lengths.
constexpr double rounding = 2e-16;

/// Share of a concentration, and of the free share of the sites beside it, that a guess must leave.
constexpr double depletion_limit = 0.3;

constexpr std::size_t nodes_per_block = 1024;

} // namespace

TimeIntegrator::TimeIntegrator(const ScaledGrid& grid, const DerivedScales& scales,
                               FixedCharge& fixed_charge, ElectrodePotentials potentials,
                               ElectrodeCharges& electrodes, NewtonKrylov& solver,
                               parallel::WorkerTeam& team)
    : grid_(grid), scales_(scales), fixed_charge_(fixed_charge), potentials_(std::move(potentials)),
      electrodes_(electrodes), solver_(solver), team_(team), charge_norm_(grid),
      resting_amount_(ExactAverage::total(grid, std::vector<double>(grid.nodes(), 1.0))),
      settled_(grid.nodes()), start_(grid.nodes()), middle_rate_(grid.nodes()),
      end_rate_(grid.nodes()), middle_(grid.nodes()), end_(grid.nodes()) {}

template <class Body> void TimeIntegrator::for_nodes(const Body& body) const {
  const bool releases = fixed_charge_.releases_ions();
  const auto& ratio = fixed_charge_.ratio();
  team_.for_blocks(grid_.nodes(), nodes_per_block,
                   [&](std::size_t begin, std::size_t end, std::size_t) {
                     for (std::size_t i = begin; i < end; ++i) {
                       body(i, releases ? ratio[i] - 1.0 : 0.0);
                     }
                   });
}

void TimeIntegrator::initialise(double time, TransportState& state) {
  state = {IonState(grid_.nodes()), std::vector<double>(2 * grid_.nodes(), 0.0), 0.0, 0.0, {}};
  fixed_charge_.start(time);
  electrodes_.start_run();
  std::ranges::fill(start_, 1.0);
  implicit_ = 0.0;
  const StageProblem problem = problem_at(time);
  std::ranges::copy(start_, state.ions.values.begin());
  if (!find_potential(problem, state)) {
    throw SolverError("Poisson's equation of the initial state could not be solved",
                      "check the shear and the electrode potentials at the first instant");
  }
  electrodes_.reach_end(state.ions);
  electrodes_.accept(state);
  settle(state);
}

void TimeIntegrator::take_up(double time, TransportState& state) {
  fixed_charge_.restore(state.memory);
  fixed_charge_.evaluate(time);
  settle(state);
}

void TimeIntegrator::restart(double time, TransportState& state) {
  start_ = settled_;
  implicit_ = 0.0;
  if (!find_potential(problem_at(time), state)) {
    throw SolverError("Poisson's equation could not be solved where a scan goes to the next row",
                      "raise numerics.mesh_refinement, or ground the other rows of the scan");
  }
  settle(state);
}

bool TimeIntegrator::find_potential(const StageProblem& problem, TransportState& state) {
  solver_.prepare(state.ions, 0.0);
  if (!solver_.solve(problem, state.ions)) {
    return false;
  }
  const std::span<double> rates(state.rate);
  solver_.rate(problem, state.ions, rates.first(grid_.nodes()));
  std::ranges::fill(rates.last(grid_.nodes()), 0.0);
  return true;
}

void TimeIntegrator::settle(TransportState& state) {
  state.memory = fixed_charge_.memory();
  state.charge_scale =
      std::max(state.charge_scale, charge_norm_.of_state(state.ions, fixed_charge_.ratio()));
  for_nodes([&](std::size_t i, double released) { settled_[i] = state.ions.values[i] - released; });
  electrodes_.settle(state);
}

StageProblem TimeIntegrator::problem_at(double time) {
  fixed_charge_.evaluate(time);
  double ion_amount = resting_amount_;
  if (fixed_charge_.releases_ions()) {
    for_nodes([&](std::size_t i, double released) { start_[i] += released; });
    ion_amount = ExactAverage::total(grid_, fixed_charge_.ratio());
  }
  StageProblem problem{.start = start_,
                       .step = implicit_,
                       .fixed_charge = fixed_charge_.ratio(),
                       .potential_bottom = potentials_.bottom(time) / scales_.potential_scale,
                       .potential_top = potentials_.top(time) / scales_.potential_scale,
                       .ion_amount = ion_amount,
                       .drive = fixed_charge_.drive()};
  electrodes_.add_equations(problem);
  return problem;
}

std::optional<double> TimeIntegrator::try_step(double begin, double end,
                                               const TransportState& state, double column_share) {
  length_ = (end - begin) / scales_.relaxation_time;
  implicit_ = tr_bdf2::diagonal * length_;
  solver_.prepare(state.ions, implicit_);

  electrodes_.begin_step(length_);
  for_nodes([&](std::size_t i, double) { start_[i] = settled_[i] + implicit_ * state.rate[i]; });
  const StageProblem at_middle = problem_at(begin + stage_fraction * (end - begin));
  guess_middle(state);
  if (!solver_.solve(at_middle, middle_)) {
    return std::nullopt;
  }

  electrodes_.reach_middle(middle_);
  for_nodes([&](std::size_t i, double) {
    middle_rate_[i] = (middle_.values[i] - start_[i]) / implicit_;
    start_[i] = settled_[i] + tr_bdf2::weight * length_ * (state.rate[i] + middle_rate_[i]);
  });
  const StageProblem at_end = problem_at(end);
  guess_end(state);
  if (!solver_.solve(at_end, end_)) {
    return std::nullopt;
  }

  electrodes_.reach_end(end_);
  for_nodes(
      [&](std::size_t i, double) { end_rate_[i] = (end_.values[i] - start_[i]) / implicit_; });
  const double error = step_error(state, column_share);
  return std::isfinite(error) ? std::optional(error) : std::nullopt;
}

void TimeIntegrator::guess_middle(const TransportState& state) {
  const std::size_t nodes = grid_.nodes();
  const double ahead = stage_fraction * length_;
  for_nodes([&](std::size_t i, double released) {
    const std::size_t p = nodes + i;
    middle_.values[i] = settled_[i] + released + ahead * state.rate[i];
    middle_.values[p] = state.ions.values[p] + ahead * state.rate[p];
  });
  keep_in_bounds(state.ions, middle_);
  electrodes_.correct_guess(middle_);
}

void TimeIntegrator::guess_end(const TransportState& state) {
  const std::size_t nodes = grid_.nodes();
  constexpr double ratio = 1.0 / stage_fraction;
  for_nodes([&](std::size_t i, double released) {
    const std::size_t p = nodes + i;
    const double slope = length_ * state.rate[i];
    const double change = implicit_ * (state.rate[i] + middle_rate_[i]); // until the stage
    end_.values[i] =
        settled_[i] + released + slope + ratio * ratio * (change - stage_fraction * slope);
    end_.values[p] = state.ions.values[p] + ratio * (middle_.values[p] - state.ions.values[p]);
  });
  keep_in_bounds(middle_, end_);
  electrodes_.correct_guess(end_);
}

void TimeIntegrator::keep_in_bounds(const IonState& safe, IonState& guess) const {
  std::atomic<bool> depleted = false;
  team_.for_blocks(guess.nodes(), nodes_per_block,
                   [&](std::size_t begin, std::size_t end, std::size_t) {
                     std::size_t count = 0;
                     for (std::size_t i = begin; i < end; ++i) {
                       count += guess.values[i] > depletion_limit * safe.values[i] ? 0 : 1;
                     }
                     if (count > 0) {
                       depleted = true;
                     }
                   });
  const auto& excess = solver_.excess();
  if (depleted || (excess && !excess->leaves_room(safe.concentration(), guess.concentration(),
                                                  depletion_limit))) {
    guess.values = safe.values;
  }
}

double TimeIntegrator::step_error(const TransportState& state, double column_share) {
  for_nodes([&](std::size_t i, double) {
    start_[i] = length_ *
                (tr_bdf2::error_of_begin * state.rate[i] +
                 tr_bdf2::error_of_middle * middle_rate_[i] + tr_bdf2::error_of_end * end_rate_[i]);
  });
  const double moved = electrodes_.step_error(start_, column_share, solver_, charge_norm_);
  const double error = base::nan_max(0.0, moved - rounding * grid_.thickness);
  const double scale =
      std::max(state.charge_scale, charge_norm_.of_state(end_, fixed_charge_.ratio()));
  return error == 0.0 ? 0.0 : error / scale;
}

void TimeIntegrator::accept(TransportState& state) {
  const std::size_t nodes = grid_.nodes();
  // Slope at the end of the parabola through begin, middle stage and end.
  constexpr double rest = 1.0 - stage_fraction;
  for_nodes([&](std::size_t i, double) {
    const std::size_t p = nodes + i;
    const double late = (end_.values[p] - middle_.values[p]) / (rest * length_);
    const double early = (middle_.values[p] - state.ions.values[p]) / (stage_fraction * length_);
    state.rate[i] = end_rate_[i];
    state.rate[p] = late + rest * (late - early);
  });
  std::swap(state.ions.values, end_.values);
  electrodes_.accept(state);
  fixed_charge_.accept(state.ions.concentration());
  settle(state);
}

} // namespace ionskin::electrochemistry
