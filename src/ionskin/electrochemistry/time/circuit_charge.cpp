// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/time/circuit_charge.hpp"

#include "ionskin/base/largest.hpp"
#include "ionskin/electrochemistry/time/tr_bdf2.hpp"

#include <cmath>

namespace ionskin::electrochemistry {
namespace {

double face_voltage(const IonState& ions) {
  return ions.potential().back() - ions.potential().front();
}

} // namespace

CircuitCharge::CircuitCharge(const ScaledGrid& grid, const FixedCharge& fixed_charge,
                             const ScaledAdmittance& admittance)
    : ElectrodeCharges(grid, fixed_charge), admittance_(admittance) {}

double CircuitCharge::rate(const IonState& ions) const {
  return -admittance_.conductance * face_voltage(ions);
}

void CircuitCharge::start_run() {
  start_ = 0.0;
}

void CircuitCharge::settle(const TransportState& state) {
  const double voltage = face_voltage(state.ions);
  settled_ = terminals_.polarisation(state.ions.concentration(), fixed_charge_.ratio()) +
             voltage / grid_.thickness;
  settled_ += admittance_.capacitance * voltage;
  begin_rate_ = rate(state.ions);
}

void CircuitCharge::begin_step(double length) {
  length_ = length;
  start_ = settled_ + tr_bdf2::diagonal * length_ * begin_rate_;
}

void CircuitCharge::add_equations(StageProblem& problem) {
  problem.circuit =
      CircuitStage{start_, problem.step * admittance_.conductance + admittance_.capacitance};
}

void CircuitCharge::reach_middle(const IonState& ions) {
  middle_rate_ = rate(ions);
  start_ = settled_ + tr_bdf2::weight * length_ * (begin_rate_ + middle_rate_);
}

void CircuitCharge::reach_end(const IonState& ions) {
  end_rate_ = rate(ions);
}

double CircuitCharge::step_error(std::span<const double> change, double column_share,
                                 NewtonKrylov& solver, const ChargeNorm& norm) const {
  const double passed =
      length_ * (tr_bdf2::error_of_begin * begin_rate_ + tr_bdf2::error_of_middle * middle_rate_ +
                 tr_bdf2::error_of_end * end_rate_);
  return base::nan_max(ElectrodeCharges::step_error(change, column_share, solver, norm),
                       std::abs(passed));
}

ElectrodeReading CircuitCharge::reading(std::span<const double> settled,
                                        const TransportState& state) const {
  const Relaxation of_ions = ElectrodeCharges::reading(settled, state).relaxation;
  // The conserved charge is smooth in time; the capacitor's charge follows the voltage, which
  // follows the shear.
  const double share = admittance_.capacitance / (1.0 / grid_.thickness + admittance_.capacitance);
  return {{settled_ - share * (settled_ - of_ions.charge),
           begin_rate_ - share * (begin_rate_ - of_ions.rate)},
          {},
          {}};
}

} // namespace ionskin::electrochemistry
