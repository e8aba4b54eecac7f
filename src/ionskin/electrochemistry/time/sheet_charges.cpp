// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/time/sheet_charges.hpp"

#include "ionskin/electrochemistry/grid/charges.hpp"
#include "ionskin/electrochemistry/time/tr_bdf2.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace ionskin::electrochemistry {
namespace {

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// Half of the difference between two means over the columns, top minus bottom. For charges it is
/// the charge per area that comes through the leads, all of which changes smoothly in time.
double half_difference(const std::array<std::vector<double>, 2>& values) {
  return 0.5 * (mean(values[top_wall]) - mean(values[bottom_wall]));
}

} // namespace

SheetState::SheetState(std::size_t columns) {
  for (std::size_t wall = 0; wall < 2; ++wall) {
    charge[wall].assign(columns, 0.0);
    rate[wall].assign(columns, 0.0);
  }
}

SheetState SheetState::unpacked(std::span<const double> values) {
  SheetState state((values.size() - 3) / 4);
  auto from = values.begin();
  for (auto* part : {&state.charge[0], &state.charge[1], &state.rate[0], &state.rate[1]}) {
    const auto until = from + static_cast<std::ptrdiff_t>(part->size());
    std::copy(from, until, part->begin());
    from = until;
  }
  state.passed = from[0];
  state.passed_rate = from[1];
  state.voltage = from[2];
  return state;
}

std::vector<double> SheetState::packed() const {
  std::vector<double> values;
  for (const auto* part : {&charge[0], &charge[1], &rate[0], &rate[1]}) {
    values.insert(values.end(), part->begin(), part->end());
  }
  values.insert(values.end(), {passed, passed_rate, voltage});
  return values;
}

SheetCharges::SheetCharges(const ScaledGrid& grid, const FixedCharge& fixed_charge,
                           const SheetElectrodes& electrodes)
    : ElectrodeCharges(grid, fixed_charge), electrodes_(electrodes), begin_(grid.columns()),
      middle_(begin_), end_(begin_) {}

void SheetCharges::start_run() {
  begin_ = SheetState(grid_.columns());
  start_stage(0.0, 0.0);
}

void SheetCharges::settle(const TransportState& state) {
  begin_ = SheetState::unpacked(state.electrode_charge);
}

void SheetCharges::begin_step(double length) {
  length_ = length;
  start_stage(tr_bdf2::diagonal * length, 0.0);
}

void SheetCharges::start_stage(double of_begin, double of_middle) {
  start_ = begin_.charge;
  for (std::size_t wall = 0; wall < 2; ++wall) {
    for (std::size_t i = 0; i < start_[wall].size(); ++i) {
      start_[wall][i] += of_begin * begin_.rate[wall][i] + of_middle * middle_.rate[wall][i];
    }
  }
  start_passed_ = begin_.passed + of_begin * begin_.passed_rate + of_middle * middle_.passed_rate;
}

void SheetCharges::add_equations(StageProblem& problem) {
  const double step = SheetElectrodes::implicit_step(problem.step);
  const std::vector<double> net = fixed_charge_.net_of_columns();
  stage_ = {start_, mean(start_[top_wall]), step, std::nullopt};
  for (std::vector<double>& charge : stage_.start) {
    for (std::size_t i = 0; i < charge.size(); ++i) {
      charge[i] += net[i];
    }
  }
  if (electrodes_.admittance()) {
    stage_.circuit = CircuitStage{start_passed_, electrodes_.circuit_conductance(step)};
  }
  problem.sheets = &stage_;
}

void SheetCharges::reach_middle(const IonState& ions) {
  middle_ = reached(ions);
  start_stage(tr_bdf2::weight * length_, tr_bdf2::weight * length_);
}

void SheetCharges::reach_end(const IonState& ions) {
  end_ = reached(ions);
}

SheetState SheetCharges::reached(const IonState& ions) const {
  const std::vector<double> net = fixed_charge_.net_of_columns();
  SheetState state(grid_.columns());
  WallCharges walls;
  wall_charges(grid_, ions, fixed_charge_.ratio(), walls);
  state.charge = {std::move(walls.bottom), std::move(walls.top)};
  for (std::size_t wall = 0; wall < 2; ++wall) {
    for (std::size_t i = 0; i < net.size(); ++i) {
      state.charge[wall][i] -= net[i];
      state.rate[wall][i] = (state.charge[wall][i] - start_[wall][i]) / stage_.step;
    }
  }
  if (stage_.circuit) {
    const double bottom = 0.0; // the lead of the bottom electrode is at the ground
    state.voltage =
        electrodes_.lead_potential(stage_, bottom, bottom, ions.potential().last(grid_.columns()));
    state.passed_rate = -electrodes_.admittance()->conductance * state.voltage;
    state.passed = start_passed_ + stage_.step * state.passed_rate;
  }
  return state;
}

double SheetCharges::step_error(std::span<const double> change, double column_share,
                                NewtonKrylov& solver, const ChargeNorm& norm) const {
  const double of_begin = length_ * tr_bdf2::error_of_begin,
               of_middle = length_ * tr_bdf2::error_of_middle,
               of_end = length_ * tr_bdf2::error_of_end;
  std::array<std::vector<double>, 2> brought = begin_.rate;
  for (std::size_t wall = 0; wall < 2; ++wall) {
    for (std::size_t i = 0; i < brought[wall].size(); ++i) {
      brought[wall][i] = of_begin * begin_.rate[wall][i] + of_middle * middle_.rate[wall][i] +
                         of_end * end_.rate[wall][i];
    }
  }
  return norm.of_change(solver.damped_charges(change, brought), column_share);
}

void SheetCharges::accept(TransportState& state) const {
  state.electrode_charge = end_.packed();
}

ElectrodeReading SheetCharges::reading(std::span<const double>, const TransportState&) const {
  return {{half_difference(begin_.charge), half_difference(begin_.rate)}, {}, begin_.voltage};
}

} // namespace ionskin::electrochemistry
