// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/electrochemistry/circuit/wall_electrodes.hpp"
#include "ionskin/electrochemistry/time/electrode_charges.hpp"

#include <optional>
#include <vector>

namespace ionskin::electrochemistry {

/// Charges of the conductors of cut faces, scaled [F c0 lambda times the area of a column]. Each
/// conductor obeys d(Q - n + C u)/dt = -u/R, docs/model.md (63), where n, half of the net charge
/// that the coupling law makes in the core at the conductor, returns through the ground. The
/// charges Q - n + C u are advanced like the ions, which conserves them to rounding.
class ConductorCharges : public ElectrodeCharges {
public:
  /// @param electrodes conductors, as given to the solver; must outlive this
  ConductorCharges(const ScaledGrid& grid, const FixedCharge& fixed_charge,
                   const WallElectrodes& electrodes);

  /// Connects the conductors to circuits, one entry each, before the first instant or where a run
  /// is resumed. An empty entry holds a conductor at the ground.
  void connect(std::vector<std::optional<ScaledAdmittance>> circuits);
  /// Changes the circuits in the state settled last: conductors that come to the ground give up
  /// their voltage, capacitors of new circuits are uncharged. Potentials and rates in the core are
  /// left to `TimeIntegrator::restart`.
  void reconnect(std::vector<std::optional<ScaledAdmittance>> circuits, TransportState& state);

  std::size_t size() const override { return circuits_.size(); }
  void start_run() override;
  void settle(const TransportState& state) override;
  void begin_step(double length) override;
  void add_equations(StageProblem& problem) override;
  /// Prevents rounding errors in the potentials of conductors, at the ground or of one column
  /// beside another, from growing step by step.
  void correct_guess(IonState& guess) const override;
  void reach_middle(const IonState& ions) override;
  void reach_end(const IonState& ions) override;
  double step_error(std::span<const double> change, double column_share, NewtonKrylov& solver,
                    const ChargeNorm& norm) const override;
  void accept(TransportState& state) const override;
  ElectrodeReading reading(std::span<const double> settled,
                           const TransportState& state) const override;

private:
  std::vector<ElectrodeRow> rows(const TransportState& state) const;
  /// Rates -u/R of the charges; 0 for a conductor held at the ground.
  std::vector<double> rates(const IonState& ions) const;
  /// Charges n of the conductors at the instant evaluated last.
  std::vector<double> net_charges() const;
  /// True if the ground holds the conductor.
  bool holds(std::size_t conductor) const { return !circuits_[conductor]; }
  /// Area of a conductor, in columns.
  double area(std::size_t conductor) const;

  const WallElectrodes& electrodes_;
  std::vector<std::optional<ScaledAdmittance>> circuits_;
  double length_ = 0;                         ///< length of the current step [relaxation times]
  std::vector<double> settled_, start_, end_; ///< charges at the begin, of a stage, at the end
  std::vector<double> begin_rates_, middle_rates_, end_rates_; ///< of the charges
  ElectrodeStage stage_;
};

} // namespace ionskin::electrochemistry
