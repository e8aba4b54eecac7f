// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/electrochemistry/circuit/external_circuit.hpp"
#include "ionskin/electrochemistry/time/electrode_charges.hpp"

namespace ionskin::electrochemistry {

/// Charge of two electrodes, each of one potential, with one circuit between them. Half of the
/// difference q of the electrodes' charges per area obeys d(q + C U)/dt = -U/R, with the voltage U,
/// top minus bottom: q and the charge on the circuit's capacitor are conserved together.
class CircuitCharge : public ElectrodeCharges {
public:
  CircuitCharge(const ScaledGrid& grid, const FixedCharge& fixed_charge,
                const ScaledAdmittance& admittance);

  void start_run() override;
  void settle(const TransportState& state) override;
  void begin_step(double length) override;
  void add_equations(StageProblem& problem) override;
  void reach_middle(const IonState& ions) override;
  void reach_end(const IonState& ions) override;
  double step_error(std::span<const double> change, double column_share, NewtonKrylov& solver,
                    const ChargeNorm& norm) const override;
  ElectrodeReading reading(std::span<const double> settled,
                           const TransportState& state) const override;

private:
  /// Rate of q + C U: the current through the circuit's resistor.
  double rate(const IonState& ions) const;

  ScaledAdmittance admittance_;
  double length_ = 0;  ///< length of the current step [relaxation times]
  double settled_ = 0; ///< q + C U where the step begins [F c0 lambda]
  double start_ = 0;   ///< q + C U from which a stage starts [F c0 lambda]
  double begin_rate_ = 0, middle_rate_ = 0, end_rate_ = 0; ///< of q + C U in the current step
};

} // namespace ionskin::electrochemistry
