// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/time_integrator.hpp"

#include "ionskin/base/error.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <utility>

namespace ionskin::electrochemistry {
namespace {

constexpr double stage_fraction = 1.0 - 0.5 * std::numbers::sqrt2;
constexpr int halving_limit = 8;

} // namespace

TimeIntegrator::TimeIntegrator(const ScaledGrid& grid, const DerivedScales& scales,
                               FixedCharge& fixed_charge, ElectrodePotentials potentials,
                               NewtonKrylov& solver)
    : grid_(grid), scales_(scales), fixed_charge_(fixed_charge), potentials_(std::move(potentials)),
      solver_(solver), start_(grid.nodes()), stage_(grid.nodes()), end_(grid.nodes()),
      slope_(2 * grid.nodes()) {}

bool TimeIntegrator::solve_stage(double time, double step, IonState& state) {
  fixed_charge_.evaluate(time);
  return solver_.solve({start_, step, fixed_charge_.ratio(),
                        potentials_.bottom(time) / scales_.potential_scale,
                        potentials_.top(time) / scales_.potential_scale},
                       state);
}

void TimeIntegrator::initialise(double time, TransportState& state) {
  state.ions = IonState(grid_.nodes());
  std::ranges::fill(state.ions.concentration(), 1.0);
  state.rate.assign(2 * grid_.nodes(), 0.0);
  std::ranges::fill(start_, 1.0);
  solver_.prepare(state.ions, 0.0);
  if (!solve_stage(time, 0.0, state.ions)) {
    throw SolverError("Poisson's equation of the initial state could not be solved",
                      "check the shear and the electrode potentials at the first instant");
  }
}

void TimeIntegrator::extrapolate(const IonState& state, double factor,
                                 const std::vector<double>& direction, IonState& guess) const {
  bool positive = true;
  for (std::size_t i = 0; i < state.values.size(); ++i) {
    guess.values[i] = state.values[i] + factor * direction[i];
    positive = positive && (i >= state.nodes() || guess.values[i] > 0.5 * state.values[i]);
  }
  if (!positive) {
    guess.values = state.values;
  }
}

bool TimeIntegrator::try_step(double begin, double end, TransportState& state) {
  const double length = (end - begin) / scales_.relaxation_time;
  const double implicit = stage_fraction * length;
  const auto concentration = state.ions.concentration();
  solver_.prepare(state.ions, implicit);

  std::ranges::copy(concentration, start_.begin());
  extrapolate(state.ions, implicit, state.rate, stage_);
  if (!solve_stage(begin + stage_fraction * (end - begin), implicit, stage_)) {
    return false;
  }

  for (std::size_t i = 0; i < slope_.size(); ++i) {
    slope_[i] = (stage_.values[i] - state.ions.values[i]) / implicit;
  }
  for (std::size_t i = 0; i < start_.size(); ++i) {
    start_[i] = concentration[i] + (1.0 - stage_fraction) * length * slope_[i];
  }
  extrapolate(state.ions, length, slope_, end_);
  if (!solve_stage(end, implicit, end_)) {
    return false;
  }

  for (std::size_t i = 0; i < state.rate.size(); ++i) {
    state.rate[i] = (end_.values[i] - stage_.values[i]) / (length - implicit);
  }
  std::swap(state.ions.values, end_.values);
  return true;
}

void TimeIntegrator::advance(double begin, double end, TransportState& state) {
  advance_halved(begin, end, state, 0);
}

void TimeIntegrator::advance_halved(double begin, double end, TransportState& state, int halvings) {
  if (try_step(begin, end, state)) {
    return;
  }
  if (halvings == halving_limit) {
    const auto c = state.ions.concentration();
    throw SolverError(
        fmt::format("the ion transport found no solution between t = {:.9g} s and {:.9g} s; before "
                    "that the smallest concentration was {:.3g} of its initial value",
                    begin, end, *std::ranges::min_element(c)),
        "raise numerics.time_refinement or numerics.mesh_refinement, or make "
        "coupling.coefficient or the electrode potentials smaller");
  }
  const double middle = 0.5 * (begin + end);
  advance_halved(begin, middle, state, halvings + 1);
  advance_halved(middle, end, state, halvings + 1);
}

} // namespace ionskin::electrochemistry
