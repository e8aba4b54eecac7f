// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/electrochemistry/circuit/sheet_electrodes.hpp"
#include "ionskin/electrochemistry/time/electrode_charges.hpp"

#include <array>
#include <span>
#include <vector>

namespace ionskin::electrochemistry {

/// State of electrodes with a sheet resistance at an instant, scaled. `charge` and `rate` are the
/// charge per area of every column, without the net charge that returns through the ground, and its
/// rate of change, [bottom, top][y][x]. `passed` and `passed_rate` are the charge per area that the
/// circuit conserves, of the top electrode and of the circuit's capacitor, and its rate. `voltage`
/// is the potential of the top lead against the bottom one.
struct SheetState {
  std::array<std::vector<double>, 2> charge, rate;
  double passed = 0, passed_rate = 0, voltage = 0;

  /// Makes the state at rest, without charge, on a number of lateral columns.
  explicit SheetState(std::size_t columns);
  /// Restores a state from the numbers that `packed` has made of it.
  static SheetState unpacked(std::span<const double> values);
  /// Makes one vector of all numbers of the state, for checkpoints.
  std::vector<double> packed() const;
  /// Length of a packed state on a grid with this number of columns.
  static std::size_t packed_size(std::size_t columns) { return 4 * columns + 3; }
};

/// Charges of electrodes with a sheet resistance, docs/model.md (67). The rate of an implicit stage
/// is the charge that the stage has brought over its length: where metal conducts well, the product
/// of conductance and difference in potential would lose digits.
class SheetCharges : public ElectrodeCharges {
public:
  /// @param electrodes as given to the solver; must outlive this
  SheetCharges(const ScaledGrid& grid, const FixedCharge& fixed_charge,
               const SheetElectrodes& electrodes);

  std::size_t size() const override { return SheetState::packed_size(grid_.columns()); }
  void start_run() override;
  void settle(const TransportState& state) override;
  void begin_step(double length) override;
  void add_equations(StageProblem& problem) override;
  void reach_middle(const IonState& ions) override;
  void reach_end(const IonState& ions) override;
  double step_error(std::span<const double> change, double column_share, NewtonKrylov& solver,
                    const ChargeNorm& norm) const override;
  void accept(TransportState& state) const override;
  ElectrodeReading reading(std::span<const double> settled,
                           const TransportState& state) const override;

private:
  /// Sets the charges from which the next stage starts: those at the begin of the step, plus
  /// `of_begin` times their rate there and `of_middle` times their rate in the middle stage
  /// [relaxation times].
  void start_stage(double of_begin, double of_middle);
  /// Computes the state of the metal from the solution of the current stage.
  SheetState reached(const IonState& ions) const;

  const SheetElectrodes& electrodes_;
  double length_ = 0; ///< length of the current step [relaxation times]
  SheetState begin_, middle_, end_;
  std::array<std::vector<double>, 2> start_; ///< charges from which the current stage starts
  double start_passed_ = 0;
  SheetStage stage_;
};

} // namespace ionskin::electrochemistry
