// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/time/time_integrator.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/base/largest.hpp"
#include "ionskin/electrochemistry/grid/charges.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

namespace ionskin::electrochemistry {
namespace {

// Weights of the rates at the begin, at the stage (a share 2 d of the step) and at the end.
constexpr double diagonal = 1.0 - 0.5 * std::numbers::sqrt2; // d
constexpr double stage_fraction = 2.0 * diagonal;
constexpr double weight = 0.25 * std::numbers::sqrt2; // w; the formula of order 2 is (w, w, d)
/// Weights of the error estimate: (w, w, d) minus the embedded formula ((1 - w)/3, (3 w + 1)/3,
/// d/3) of order 3.
constexpr double error_of_begin = (4.0 * weight - 1.0) / 3.0, error_of_stage = -1.0 / 3.0,
                 error_of_end = 2.0 * diagonal / 3.0;

/// Rounding error of a concentration, which counts in the charge of a core of many Debye lengths.
constexpr double rounding = 2e-16;

/// Share of a concentration, and of the free share of the sites beside it, that a guess must leave.
constexpr double depletion_limit = 0.3;

constexpr std::size_t nodes_per_block = 1024;

} // namespace

TimeIntegrator::TimeIntegrator(const ScaledGrid& grid, const DerivedScales& scales,
                               FixedCharge& fixed_charge, ElectrodePotentials potentials,
                               NewtonKrylov& solver, parallel::WorkerTeam& team,
                               std::optional<ScaledAdmittance> admittance,
                               const WallElectrodes* electrodes, const SheetElectrodes* sheets)
    : grid_(grid), scales_(scales), fixed_charge_(fixed_charge), potentials_(std::move(potentials)),
      solver_(solver), team_(team), admittance_(admittance), terminals_(grid), charge_norm_(grid),
      resting_amount_(ExactAverage::total(grid, std::vector<double>(grid.nodes(), 1.0))),
      settled_(grid.nodes()), start_(grid.nodes()), stage_rate_(grid.nodes()),
      end_rate_(grid.nodes()), stage_(grid.nodes()), end_(grid.nodes()) {
  if (electrodes != nullptr) {
    electrodes_.emplace(*electrodes);
  }
  if (sheets != nullptr) {
    sheets_.emplace(grid, *sheets);
  }
}

namespace {

/// Computes amounts + factor * rates.
std::vector<double> sum(std::vector<double> amounts, double factor,
                        const std::vector<double>& rates) {
  for (std::size_t i = 0; i < amounts.size(); ++i) {
    amounts[i] += factor * rates[i];
  }
  return amounts;
}

} // namespace

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

void TimeIntegrator::settle(const IonState& ions) {
  for_nodes([&](std::size_t i, double released) { settled_[i] = ions.values[i] - released; });
  settled_charge_ = terminals_.polarisation(ions.concentration(), fixed_charge_.ratio()) +
                    voltage(ions) / grid_.thickness;
  if (admittance_) {
    settled_charge_ += admittance_->capacitance * voltage(ions);
  }
}

std::vector<double> TimeIntegrator::potentials(const IonState& ions) const {
  return electrodes_->electrodes().potentials(ions.potential());
}

std::vector<double> TimeIntegrator::net_of_columns() const {
  const std::size_t columns = grid_.columns();
  std::vector<double> net(columns, 0.0);
  if (fixed_charge_.makes_net_charge()) {
    for (std::size_t i = 0; i < grid_.nodes(); ++i) {
      net[i % columns] += 0.5 * grid_.height[i / columns] * (fixed_charge_.ratio()[i] - 1.0);
    }
  }
  return net;
}

std::vector<double> TimeIntegrator::net_charges() const {
  return electrodes_->electrodes().sums(net_of_columns());
}

double TimeIntegrator::largest_of_conductors(const std::vector<double>& charges) const {
  double largest = 0.0;
  for (std::size_t e = 0; e < charges.size(); ++e) {
    largest = base::nan_max(largest, std::abs(charges[e]) / area(e));
  }
  return largest;
}

double TimeIntegrator::area(std::size_t conductor) const {
  const std::vector<double>& share = electrodes_->electrodes().conductors()[conductor].share;
  return std::accumulate(share.begin(), share.end(), 0.0);
}

double TimeIntegrator::voltage(const IonState& ions) const {
  return ions.potential().back() - ions.potential().front();
}

double TimeIntegrator::charge_rate(const IonState& ions) const {
  return admittance_ ? -admittance_->conductance * voltage(ions) : 0.0;
}

void TimeIntegrator::note_charge(TransportState& state) {
  state.charge_scale =
      std::max(state.charge_scale, charge_norm_.of_state(state.ions, fixed_charge_.ratio()));
}

/// Makes the problem of the stage at an instant [s]: evaluates charges and potentials given there,
/// and adds the ions released until then to `start_`.
StageProblem TimeIntegrator::problem_at(double time) {
  fixed_charge_.evaluate(time);
  double ion_amount = resting_amount_;
  if (fixed_charge_.releases_ions()) {
    for_nodes([&](std::size_t i, double released) { start_[i] += released; });
    ion_amount = ExactAverage::total(grid_, fixed_charge_.ratio());
  }
  if (electrodes_) {
    electrode_stage_ = electrodes_->stage(start_charges_, implicit_, net_charges());
  }
  if (sheets_) {
    sheet_stage_ = sheets_->stage(implicit_, net_of_columns());
  }
  return {start_,
          implicit_,
          fixed_charge_.ratio(),
          potentials_.bottom(time) / scales_.potential_scale,
          potentials_.top(time) / scales_.potential_scale,
          ion_amount,
          admittance_
              ? std::optional(CircuitStage{start_charge_, implicit_ * admittance_->conductance +
                                                              admittance_->capacitance})
              : std::nullopt,
          fixed_charge_.drive(),
          electrodes_ ? &electrode_stage_ : nullptr,
          sheets_ ? &sheet_stage_ : nullptr};
}

void TimeIntegrator::initialise(double time, TransportState& state) {
  state = {IonState(grid_.nodes()), std::vector<double>(2 * grid_.nodes(), 0.0), 0.0, 0.0, {}};
  fixed_charge_.start(time);
  std::ranges::fill(start_, 1.0);
  implicit_ = 0.0;
  start_charge_ = 0.0;
  if (electrodes_) {
    start_charges_.assign(electrodes_->electrodes().size(), 0.0);
    state.electrode_charge = start_charges_;
  }
  if (sheets_) {
    sheets_->begin(SheetState(grid_.columns()).packed());
    sheets_->start(0.0, 0.0);
  }
  const StageProblem problem = problem_at(time);
  std::ranges::copy(start_, state.ions.values.begin());
  solver_.prepare(state.ions, 0.0);
  if (!solver_.solve(problem, state.ions)) {
    throw SolverError("Poisson's equation of the initial state could not be solved",
                      "check the shear and the electrode potentials at the first instant");
  }
  solver_.rate(problem, state.ions, std::span(state.rate).first(grid_.nodes()));
  if (sheets_) {
    sheets_->reach_end(sheet_stage_, state.ions, fixed_charge_.ratio(), net_of_columns());
    state.electrode_charge = sheets_->end().packed();
  }
  state.memory = fixed_charge_.memory();
  settle(state.ions);
  note_charge(state);
}

void TimeIntegrator::take_up(double time, const TransportState& state) {
  fixed_charge_.restore(state.memory);
  fixed_charge_.evaluate(time);
  settle(state.ions);
}

void TimeIntegrator::connect(std::vector<std::optional<ScaledAdmittance>> circuits) {
  electrodes_->connect(std::move(circuits));
}

void TimeIntegrator::reconnect(double time, std::vector<std::optional<ScaledAdmittance>> circuits,
                               TransportState& state) {
  const std::vector<ElectrodeRow> rows = electrode_rows(state);
  std::vector<double> held_at = potentials(state.ions);
  for (std::size_t e = 0; e < rows.size(); ++e) {
    if (electrodes_->circuits()[e] != circuits[e]) {
      state.electrode_charge[e] = rows[e].passed;
      held_at[e] = circuits[e] ? held_at[e] : 0.0;
    }
  }
  connect(std::move(circuits));
  electrodes_->electrodes().spread(held_at, state.ions.potential());
  implicit_ = 0.0;
  start_ = settled_;
  start_charges_ = state.electrode_charge;
  const StageProblem problem = problem_at(time);
  solver_.prepare(state.ions, 0.0);
  if (!solver_.solve(problem, state.ions)) {
    throw SolverError("Poisson's equation could not be solved where a scan goes to the next row",
                      "raise numerics.mesh_refinement, or ground the other rows of the scan");
  }
  solver_.rate(problem, state.ions, std::span(state.rate).first(grid_.nodes()));
  std::fill(state.rate.begin() + static_cast<std::ptrdiff_t>(grid_.nodes()), state.rate.end(), 0.0);
  settle(state.ions);
  note_charge(state);
}

std::optional<double> TimeIntegrator::try_step(double begin, double end,
                                               const TransportState& state, double column_share) {
  length_ = (end - begin) / scales_.relaxation_time;
  implicit_ = diagonal * length_;
  solver_.prepare(state.ions, implicit_);
  for_nodes([&](std::size_t i, double) { start_[i] = settled_[i] + implicit_ * state.rate[i]; });
  start_charge_ = settled_charge_ + implicit_ * charge_rate(state.ions);
  std::vector<double> begin_rates, stage_rates;
  if (electrodes_) {
    begin_rates = electrodes_->rates(potentials(state.ions));
    start_charges_ = sum(state.electrode_charge, implicit_, begin_rates);
  }
  if (sheets_) {
    sheets_->begin(state.electrode_charge);
    sheets_->start(implicit_, 0.0);
  }
  const StageProblem at_stage = problem_at(begin + stage_fraction * (end - begin));
  guess_stage(state);
  if (!solver_.solve(at_stage, stage_)) {
    return std::nullopt;
  }
  if (sheets_) {
    sheets_->reach_middle(sheet_stage_, stage_, fixed_charge_.ratio(), net_of_columns());
    sheets_->start(weight * length_, weight * length_);
  }
  for_nodes([&](std::size_t i, double) {
    stage_rate_[i] = (stage_.values[i] - start_[i]) / implicit_;
    start_[i] = settled_[i] + weight * length_ * (state.rate[i] + stage_rate_[i]);
  });
  start_charge_ =
      settled_charge_ + weight * length_ * (charge_rate(state.ions) + charge_rate(stage_));
  if (electrodes_) {
    stage_rates = electrodes_->rates(potentials(stage_));
    start_charges_ = sum(sum(state.electrode_charge, weight * length_, begin_rates),
                         weight * length_, stage_rates);
  }
  const StageProblem at_end = problem_at(end);
  guess_end(state);
  if (!solver_.solve(at_end, end_)) {
    return std::nullopt;
  }
  if (sheets_) {
    sheets_->reach_end(sheet_stage_, end_, fixed_charge_.ratio(), net_of_columns());
  }
  for_nodes(
      [&](std::size_t i, double) { end_rate_[i] = (end_.values[i] - start_[i]) / implicit_; });
  double passed = 0.0;
  if (electrodes_) {
    const std::vector<double> end_rates = electrodes_->rates(potentials(end_));
    end_charges_ = sum(start_charges_, implicit_, end_rates);
    const std::vector<double> nothing(end_rates.size(), 0.0);
    passed = largest_of_conductors(sum(sum(sum(nothing, length_ * error_of_begin, begin_rates),
                                           length_ * error_of_stage, stage_rates),
                                       length_ * error_of_end, end_rates));
  }
  const double error = charge_error(state, column_share, passed);
  return std::isfinite(error) ? std::optional(error) : std::nullopt;
}

/// Guesses the solution of the middle stage from the begin of the step along its rate.
void TimeIntegrator::guess_stage(const TransportState& state) {
  const std::size_t nodes = grid_.nodes();
  const double ahead = stage_fraction * length_;
  for_nodes([&](std::size_t i, double released) {
    const std::size_t p = nodes + i;
    stage_.values[i] = settled_[i] + released + ahead * state.rate[i];
    stage_.values[p] = state.ions.values[p] + ahead * state.rate[p];
  });
  keep_in_bounds(state.ions, stage_);
  restore_conductors(stage_);
}

/// Guesses the solution at the end of the step: concentrations on the parabola through begin and
/// middle stage with the rate at the begin; potentials, whose rate jumps at kinks of the shear, on
/// the straight line.
void TimeIntegrator::guess_end(const TransportState& state) {
  const std::size_t nodes = grid_.nodes();
  constexpr double ratio = 1.0 / stage_fraction;
  for_nodes([&](std::size_t i, double released) {
    const std::size_t p = nodes + i;
    const double slope = length_ * state.rate[i];
    const double change = implicit_ * (state.rate[i] + stage_rate_[i]); // until the stage
    end_.values[i] =
        settled_[i] + released + slope + ratio * ratio * (change - stage_fraction * slope);
    end_.values[p] = state.ions.values[p] + ratio * (stage_.values[p] - state.ions.values[p]);
  });
  keep_in_bounds(stage_, end_);
  restore_conductors(end_);
}

void TimeIntegrator::restore_conductors(IonState& guess) const {
  if (!electrodes_) {
    return;
  }
  std::vector<double> at = potentials(guess);
  for (std::size_t e = 0; e < at.size(); ++e) {
    at[e] = electrodes_->holds(e) ? 0.0 : at[e];
  }
  electrodes_->electrodes().spread(at, guess.potential());
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

double TimeIntegrator::charge_error(const TransportState& state, double column_share,
                                    double passed_by_conductors) {
  for_nodes([&](std::size_t i, double) {
    start_[i] = length_ * (error_of_begin * state.rate[i] + error_of_stage * stage_rate_[i] +
                           error_of_end * end_rate_[i]);
  });
  const double passed =
      length_ * (error_of_begin * charge_rate(state.ions) + error_of_stage * charge_rate(stage_) +
                 error_of_end * charge_rate(end_));
  const auto charges =
      sheets_ ? solver_.damped_charges(start_, sheets_->weighed(length_ * error_of_begin,
                                                                length_ * error_of_stage,
                                                                length_ * error_of_end))
              : solver_.damped_sums(start_, charge_norm_.weights());
  const double moved =
      base::nan_max(base::nan_max(charge_norm_.of_change(charges, column_share), std::abs(passed)),
                    column_share * passed_by_conductors);
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
    const double late = (end_.values[p] - stage_.values[p]) / (rest * length_);
    const double early = (stage_.values[p] - state.ions.values[p]) / (stage_fraction * length_);
    state.rate[i] = end_rate_[i];
    state.rate[p] = late + rest * (late - early);
  });
  std::swap(state.ions.values, end_.values);
  if (electrodes_) {
    state.electrode_charge = end_charges_;
  }
  if (sheets_) {
    state.electrode_charge = sheets_->end().packed();
  }
  fixed_charge_.accept(state.ions.concentration());
  state.memory = fixed_charge_.memory();
  settle(state.ions);
  note_charge(state);
}

std::vector<ElectrodeRow> TimeIntegrator::electrode_rows(const TransportState& state) const {
  std::vector<ElectrodeRow> rows;
  if (!electrodes_) {
    return rows;
  }
  WallCharges walls;
  wall_charges(grid_, state.ions, fixed_charge_.ratio(), walls);
  std::vector<double> of_walls = std::move(walls.bottom);
  of_walls.insert(of_walls.end(), walls.top.begin(), walls.top.end());
  const std::vector<double> on_metal = electrodes_->electrodes().sums(of_walls),
                            potential = potentials(state.ions), net = net_charges();
  // The circuits know their conserved charge to rounding, the charges on the walls are as accurate
  // as Newton's method left them.
  double left = 0.0, held_area = 0.0;
  for (std::size_t e = 0; e < potential.size(); ++e) {
    const bool held = electrodes_->holds(e);
    const double passed =
        held ? on_metal[e] - net[e]
             : state.electrode_charge[e] - electrodes_->capacitance(e) * potential[e];
    rows.push_back({held ? 0.0 : potential[e], passed + net[e], passed});
    left -= passed;
    held_area += held ? area(e) : 0.0;
  }
  if (!electrodes_->electrodes().on_bottom()) {
    return rows;
  }
  // The ground passes the rest: both walls together hold no charge but the net charge.
  for (std::size_t e = 0; e < rows.size(); ++e) {
    const double share = electrodes_->holds(e) ? left * area(e) / held_area : 0.0;
    rows[e].charge += share;
    rows[e].passed += share;
  }
  return rows;
}

std::optional<double> TimeIntegrator::lead_voltage(const TransportState& state) const {
  return sheets_ ? std::optional(SheetState::unpacked(state.electrode_charge).voltage)
                 : std::nullopt;
}

Relaxation TimeIntegrator::relaxation(const TransportState& state) const {
  if (electrodes_) {
    return {}; // conductors whose potentials follow the shear leave no smooth part
  }
  if (sheets_) {
    const SheetState metal = SheetState::unpacked(state.electrode_charge);
    return {metal.difference(metal.charge), metal.difference(metal.rate)};
  }
  const Relaxation of_ions{terminals_.of_ions(settled_, 1.0),
                           terminals_.of_ions(std::span(state.rate).first(settled_.size()), 0.0)};
  if (!admittance_) {
    return of_ions;
  }
  // The conserved charge is smooth in time; the capacitor's charge follows the voltage, which
  // follows the shear.
  const double share =
      admittance_->capacitance / (1.0 / grid_.thickness + admittance_->capacitance);
  const double rate = charge_rate(state.ions);
  return {settled_charge_ - share * (settled_charge_ - of_ions.charge),
          rate - share * (rate - of_ions.rate)};
}

} // namespace ionskin::electrochemistry
