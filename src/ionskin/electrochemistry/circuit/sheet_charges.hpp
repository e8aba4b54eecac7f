// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/electrochemistry/circuit/sheet_electrodes.hpp"
#include "ionskin/electrochemistry/output/ion_state.hpp"

#include <array>
#include <span>
#include <vector>

namespace ionskin::electrochemistry {

/// State of metal with a sheet resistance at an instant, scaled: the charge per area of every
/// column without what returns through the ground, and how fast it comes; the charge of the top
/// electrode that the circuit has passed and its capacitor holds; the voltage between the leads.
struct SheetState {
  std::array<std::vector<double>, 2> charge, rate;
  double passed = 0, passed_rate = 0, voltage = 0;

  /// State at rest, uncharged, on so many columns.
  explicit SheetState(std::size_t columns);
  /// Numbers of the state: `unpacked` takes what `packed` gives.
  static SheetState unpacked(std::span<const double> values);
  std::vector<double> packed() const;
  /// Number of values of a packed state on a grid with so many columns.
  static std::size_t packed_size(std::size_t columns) { return 4 * columns + 3; }

  /// Half of the means over the top less those over the bottom: the charge that comes through the
  /// leads, all of which changes smoothly.
  static double difference(const std::array<std::vector<double>, 2>& charges);
};

/// The charges of such metal while a run advances, docs/model.md (67): they are advanced like the
/// ions. The rate of an implicit stage is the charge that it has brought over its length, which
/// does not lose digits where metal conducts well, as the product of conductance and difference in
/// potential would.
class SheetCharges {
public:
  /// @param electrodes must outlive this, as must the grid
  SheetCharges(const ScaledGrid& grid, const SheetElectrodes& electrodes);

  const SheetElectrodes& electrodes() const { return electrodes_; }

  /// Begins a step at a state of `SheetState::packed`.
  void begin(std::span<const double> packed) { begin_ = SheetState::unpacked(packed); }
  /// Lets a stage start from the begin plus these times of the rates of begin and middle stage.
  void start(double of_begin, double of_middle);
  /// Equations of the sheets in a stage of the step that was begun.
  /// @param implicit part of the step
  /// @param net half of the net charge per area below every column, which returns through the
  ///   ground
  SheetStage stage(double implicit, std::span<const double> net) const;
  /// Takes up the solution of a stage as the middle or as the end of the step.
  void reach_middle(const SheetStage& stage, const IonState& ions,
                    std::span<const double> fixed_charge, std::span<const double> net) {
    middle_ = reached(stage, ions, fixed_charge, net);
  }
  void reach_end(const SheetStage& stage, const IonState& ions,
                 std::span<const double> fixed_charge, std::span<const double> net) {
    end_ = reached(stage, ions, fixed_charge, net);
  }
  const SheetState& end() const { return end_; }
  /// Weighed sum of the rates of the charges at begin, middle and end.
  std::array<std::vector<double>, 2> weighed(double begin, double middle, double end) const;

private:
  SheetState reached(const SheetStage& stage, const IonState& ions,
                     std::span<const double> fixed_charge, std::span<const double> net) const;

  const ScaledGrid& grid_;
  const SheetElectrodes& electrodes_;
  SheetState begin_, middle_, end_;
  std::array<std::vector<double>, 2> start_; ///< of the stage at hand
  double start_passed_ = 0;
};

} // namespace ionskin::electrochemistry
