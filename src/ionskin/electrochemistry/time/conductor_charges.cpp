// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/time/conductor_charges.hpp"

#include "ionskin/base/largest.hpp"
#include "ionskin/electrochemistry/grid/charges.hpp"
#include "ionskin/electrochemistry/time/tr_bdf2.hpp"

#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace ionskin::electrochemistry {
namespace {

/// Computes amounts + factor * rates.
std::vector<double> advanced(std::vector<double> amounts, double factor,
                             const std::vector<double>& rates) {
  for (std::size_t i = 0; i < amounts.size(); ++i) {
    amounts[i] += factor * rates[i];
  }
  return amounts;
}

} // namespace

ConductorCharges::ConductorCharges(const ScaledGrid& grid, const FixedCharge& fixed_charge,
                                   const WallElectrodes& electrodes)
    : ElectrodeCharges(grid, fixed_charge), electrodes_(electrodes) {
  for (const WallConductor& conductor : electrodes.conductors()) {
    circuits_.push_back(conductor.admittance);
  }
}

void ConductorCharges::connect(std::vector<std::optional<ScaledAdmittance>> circuits) {
  circuits_ = std::move(circuits);
}

void ConductorCharges::reconnect(std::vector<std::optional<ScaledAdmittance>> circuits,
                                 TransportState& state) {
  const std::vector<ElectrodeRow> before = rows(state);
  std::vector<double> potentials = electrodes_.potentials(state.ions.potential());
  for (std::size_t e = 0; e < before.size(); ++e) {
    if (circuits_[e] != circuits[e]) {
      state.electrode_charge[e] = before[e].passed;
      potentials[e] = circuits[e] ? potentials[e] : 0.0;
    }
  }
  connect(std::move(circuits));
  electrodes_.spread(potentials, state.ions.potential());
  start_ = state.electrode_charge;
}

std::vector<double> ConductorCharges::rates(const IonState& ions) const {
  const std::vector<double> potentials = electrodes_.potentials(ions.potential());
  std::vector<double> result(size(), 0.0);
  for (std::size_t e = 0; e < size(); ++e) {
    if (circuits_[e]) {
      result[e] = -circuits_[e]->conductance * potentials[e];
    }
  }
  return result;
}

std::vector<double> ConductorCharges::net_charges() const {
  return electrodes_.sums(fixed_charge_.net_of_columns());
}

double ConductorCharges::area(std::size_t conductor) const {
  const std::vector<double>& share = electrodes_.conductors()[conductor].share;
  return std::accumulate(share.begin(), share.end(), 0.0);
}

void ConductorCharges::start_run() {
  length_ = 0.0;
  start_.assign(size(), 0.0);
}

void ConductorCharges::settle(const TransportState& state) {
  settled_ = state.electrode_charge;
  begin_rates_ = rates(state.ions);
}

void ConductorCharges::begin_step(double length) {
  length_ = length;
  start_ = advanced(settled_, tr_bdf2::diagonal * length_, begin_rates_);
}

void ConductorCharges::add_equations(StageProblem& problem) {
  const std::vector<double> net = net_charges();
  stage_ = {};
  for (std::size_t e = 0; e < size(); ++e) {
    stage_.start.push_back(start_[e] + net[e]);
    stage_.conductance.push_back(circuits_[e] ? problem.step * circuits_[e]->conductance +
                                                    circuits_[e]->capacitance
                                              : std::numeric_limits<double>::infinity());
  }
  problem.electrodes = &stage_;
}

void ConductorCharges::correct_guess(IonState& guess) const {
  std::vector<double> potentials = electrodes_.potentials(guess.potential());
  for (std::size_t e = 0; e < size(); ++e) {
    potentials[e] = holds(e) ? 0.0 : potentials[e];
  }
  electrodes_.spread(potentials, guess.potential());
}

void ConductorCharges::reach_middle(const IonState& ions) {
  const double weighted = tr_bdf2::weight * length_;
  middle_rates_ = rates(ions);
  start_ = advanced(advanced(settled_, weighted, begin_rates_), weighted, middle_rates_);
}

void ConductorCharges::reach_end(const IonState& ions) {
  end_rates_ = rates(ions);
  end_ = advanced(start_, tr_bdf2::diagonal * length_, end_rates_);
}

double ConductorCharges::step_error(std::span<const double> change, double column_share,
                                    NewtonKrylov& solver, const ChargeNorm& norm) const {
  std::vector<double> passed(size(), 0.0);
  passed = advanced(std::move(passed), length_ * tr_bdf2::error_of_begin, begin_rates_);
  passed = advanced(std::move(passed), length_ * tr_bdf2::error_of_middle, middle_rates_);
  passed = advanced(std::move(passed), length_ * tr_bdf2::error_of_end, end_rates_);
  double largest = 0.0;
  for (std::size_t e = 0; e < size(); ++e) {
    largest = base::nan_max(largest, std::abs(passed[e]) / area(e));
  }
  return base::nan_max(ElectrodeCharges::step_error(change, column_share, solver, norm),
                       column_share * largest);
}

void ConductorCharges::accept(TransportState& state) const {
  state.electrode_charge = end_;
}

ElectrodeReading ConductorCharges::reading(std::span<const double>,
                                           const TransportState& state) const {
  return {{}, rows(state), {}}; // potentials that follow the shear leave no smooth part
}

std::vector<ElectrodeRow> ConductorCharges::rows(const TransportState& state) const {
  WallCharges walls;
  wall_charges(grid_, state.ions, fixed_charge_.ratio(), walls);
  std::vector<double> of_walls = std::move(walls.bottom);
  of_walls.insert(of_walls.end(), walls.top.begin(), walls.top.end());
  const std::vector<double> on_metal = electrodes_.sums(of_walls),
                            potential = electrodes_.potentials(state.ions.potential()),
                            net = net_charges();
  // The circuits know their conserved charge to rounding, the charges on the walls are as accurate
  // as Newton's method left them.
  std::vector<ElectrodeRow> rows;
  double left = 0.0, held_area = 0.0;
  for (std::size_t e = 0; e < size(); ++e) {
    const double passed =
        holds(e) ? on_metal[e] - net[e]
                 : state.electrode_charge[e] - circuits_[e]->capacitance * potential[e];
    rows.push_back({holds(e) ? 0.0 : potential[e], passed + net[e], passed});
    left -= passed;
    held_area += holds(e) ? area(e) : 0.0;
  }
  if (!electrodes_.on_bottom()) {
    return rows;
  }
  // The ground passes the rest: both walls together hold no charge but the net charge.
  for (std::size_t e = 0; e < size(); ++e) {
    const double share = holds(e) ? left * area(e) / held_area : 0.0;
    rows[e].charge += share;
    rows[e].passed += share;
  }
  return rows;
}

} // namespace ionskin::electrochemistry
