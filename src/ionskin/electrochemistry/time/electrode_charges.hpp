// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/electrochemistry/circuit/terminal_voltage.hpp"
#include "ionskin/electrochemistry/equations/space_charge.hpp"
#include "ionskin/electrochemistry/equations/transport_equations.hpp"
#include "ionskin/electrochemistry/grid/scaled_grid.hpp"
#include "ionskin/electrochemistry/output/ion_state.hpp"
#include "ionskin/electrochemistry/solver/charge_norm.hpp"
#include "ionskin/electrochemistry/solver/newton_krylov.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace ionskin::electrochemistry {

/// State of a conductor of a cut face at an instant: its potential [R T/(v F)], the charge on its
/// metal, and the part of that which its circuit has passed or holds [F c0 lambda times the area of
/// a column].
struct ElectrodeRow {
  double potential = 0, charge = 0, passed = 0;
};

/// Part of (Q_top - Q_bottom)/2 that changes smoothly at kinks of the shear, see
/// `IonSolution::relaxation_charge`, and its rate; per area, scaled.
struct Relaxation {
  double charge = 0, rate = 0;
};

/// Electrical state of the electrodes at an instant, for the rows of a solution.
struct ElectrodeReading {
  Relaxation relaxation;          ///< smooth part of the charge; 0 for conductors of cut faces
  std::vector<ElectrodeRow> rows; ///< conductors of cut faces; empty without
  /// Voltage between the leads of metal with sheet resistances [R T/(v F)]; nothing without.
  std::optional<double> lead_voltage;
};

/// Charges of the electrodes and their circuits while a run advances. `TimeIntegrator` carries them
/// through its time steps by the same method as the ions, TR-BDF2. This class stands for electrodes
/// whose potentials are given: nothing but the ions is integrated there. Electrodes with a circuit
/// have a derived class: `CircuitCharge`, `ConductorCharges`, `SheetCharges`. `FixedCharge` must be
/// evaluated at the instant of the state that a function gets.
class ElectrodeCharges {
public:
  /// @param grid must outlive this, as must `fixed_charge`
  ElectrodeCharges(const ScaledGrid& grid, const FixedCharge& fixed_charge);
  virtual ~ElectrodeCharges() = default;
  ElectrodeCharges(const ElectrodeCharges&) = delete;
  ElectrodeCharges& operator=(const ElectrodeCharges&) = delete;

  /// Length of `TransportState::electrode_charge`.
  virtual std::size_t size() const { return 0; }

  /// Starts a run without charge.
  virtual void start_run() {}
  /// Stores charges and rates of an accepted state, from which the next step begins.
  virtual void settle(const TransportState&) {}

  /// Begins a time step at the state settled last, and prepares its middle stage.
  /// @param length length of the step [relaxation times]
  virtual void begin_step(double /*length*/) {}
  /// Adds the equations of the electrodes to a stage, whose other members are set.
  virtual void add_equations(StageProblem&) {}
  /// Improves the guess of a stage where the electrodes know its potentials.
  virtual void correct_guess(IonState&) const {}
  /// Stores the solution of the middle stage, and prepares the stage at the end.
  virtual void reach_middle(const IonState&) {}
  /// Stores the solution at the end of the step, or at the first instant of a run.
  virtual void reach_end(const IonState&) {}
  /// Estimates the error of the charge in the step that has reached its end [F c0 lambda].
  /// @param change estimated error of the concentrations [nodes]
  /// @param column_share weight of the errors of single columns, see `ChargeNorm::of_change` [1]
  virtual double step_error(std::span<const double> change, double column_share,
                            NewtonKrylov& solver, const ChargeNorm& norm) const;
  /// Writes the charges of the end that was reached last to a state.
  virtual void accept(TransportState&) const {}

  /// Reads the electrodes in the state settled last.
  /// @param settled concentration minus released ions [nodes]
  virtual ElectrodeReading reading(std::span<const double> settled,
                                   const TransportState& state) const;

protected:
  const ScaledGrid& grid_;
  const FixedCharge& fixed_charge_;
  TerminalVoltage terminals_;
};

} // namespace ionskin::electrochemistry
