// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/circuit/sheet_charges.hpp"

#include "ionskin/electrochemistry/grid/charges.hpp"

#include <algorithm>
#include <numeric>

namespace ionskin::electrochemistry {
namespace {

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
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

double SheetState::difference(const std::array<std::vector<double>, 2>& charges) {
  return 0.5 * (mean(charges[top_wall]) - mean(charges[bottom_wall]));
}

SheetCharges::SheetCharges(const ScaledGrid& grid, const SheetElectrodes& electrodes)
    : grid_(grid), electrodes_(electrodes), begin_(grid.columns()), middle_(begin_), end_(begin_) {}

void SheetCharges::start(double of_begin, double of_middle) {
  start_ = begin_.charge;
  for (std::size_t wall = 0; wall < 2; ++wall) {
    for (std::size_t i = 0; i < start_[wall].size(); ++i) {
      start_[wall][i] += of_begin * begin_.rate[wall][i] + of_middle * middle_.rate[wall][i];
    }
  }
  start_passed_ = begin_.passed + of_begin * begin_.passed_rate + of_middle * middle_.passed_rate;
}

SheetStage SheetCharges::stage(double implicit, std::span<const double> net) const {
  const double step = SheetElectrodes::implicit_step(implicit);
  SheetStage stage{start_, mean(start_[top_wall]), step, std::nullopt};
  for (std::vector<double>& charge : stage.start) {
    for (std::size_t i = 0; i < charge.size(); ++i) {
      charge[i] += net[i];
    }
  }
  if (electrodes_.admittance()) {
    stage.circuit = CircuitStage{start_passed_, electrodes_.circuit_conductance(step)};
  }
  return stage;
}

SheetState SheetCharges::reached(const SheetStage& stage, const IonState& ions,
                                 std::span<const double> fixed_charge,
                                 std::span<const double> net) const {
  SheetState state(grid_.columns());
  WallCharges walls;
  wall_charges(grid_, ions, fixed_charge, walls);
  state.charge = {std::move(walls.bottom), std::move(walls.top)};
  for (std::size_t wall = 0; wall < 2; ++wall) {
    for (std::size_t i = 0; i < net.size(); ++i) {
      state.charge[wall][i] -= net[i];
      state.rate[wall][i] = (state.charge[wall][i] - start_[wall][i]) / stage.step;
    }
  }
  if (stage.circuit) {
    const double bottom = 0.0; // the lead of the bottom electrode is at the ground
    state.voltage =
        electrodes_.lead_potential(stage, bottom, bottom, ions.potential().last(grid_.columns()));
    state.passed_rate = -electrodes_.admittance()->conductance * state.voltage;
    state.passed = start_passed_ + stage.step * state.passed_rate;
  }
  return state;
}

std::array<std::vector<double>, 2> SheetCharges::weighed(double begin, double middle,
                                                         double end) const {
  std::array<std::vector<double>, 2> sums = begin_.rate;
  for (std::size_t wall = 0; wall < 2; ++wall) {
    for (std::size_t i = 0; i < sums[wall].size(); ++i) {
      sums[wall][i] =
          begin * begin_.rate[wall][i] + middle * middle_.rate[wall][i] + end * end_.rate[wall][i];
    }
  }
  return sums;
}

} // namespace ionskin::electrochemistry
