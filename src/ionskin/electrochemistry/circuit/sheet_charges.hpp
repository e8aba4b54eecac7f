// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/electrochemistry/circuit/sheet_electrodes.hpp"
#include "ionskin/electrochemistry/output/ion_state.hpp"

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

  /// Computes half of the difference between two means over the columns, top minus bottom. For
  /// `charge` it is the charge per area that comes through the leads, all of which changes smoothly
  /// in time.
  static double difference(const std::array<std::vector<double>, 2>& charges);
};

/// Charges of electrodes with a sheet resistance while a run advances, docs/model.md (67), by the
/// same method as the ions. The rate of an implicit stage is the charge that the stage has brought
/// over its length: where metal conducts well, the product of conductance and difference in
/// potential would lose digits.
class SheetCharges {
public:
  /// @param electrodes must outlive this, as must the grid
  SheetCharges(const ScaledGrid& grid, const SheetElectrodes& electrodes);

  const SheetElectrodes& electrodes() const { return electrodes_; }

  /// Begins a time step at a state that `SheetState::packed` has made.
  void begin(std::span<const double> packed) { begin_ = SheetState::unpacked(packed); }
  /// Sets the charges from which the next stage starts: those at the begin of the step, plus
  /// `of_begin` times their rate there and `of_middle` times their rate in the middle stage
  /// [relaxation times].
  void start(double of_begin, double of_middle);
  /// Makes the equations of the metal in a stage of the current step.
  /// @param implicit implicit part of the time step [relaxation times]
  /// @param net half of the net charge per area below every column, which returns through the
  ///   ground [y][x]
  SheetStage stage(double implicit, std::span<const double> net) const;
  /// Stores the solution of a stage as the middle or as the end of the step.
  /// @param fixed_charge cf/c0 at the instant of the stage [nodes]
  /// @param net as for `stage`
  void reach_middle(const SheetStage& stage, const IonState& ions,
                    std::span<const double> fixed_charge, std::span<const double> net) {
    middle_ = reached(stage, ions, fixed_charge, net);
  }
  void reach_end(const SheetStage& stage, const IonState& ions,
                 std::span<const double> fixed_charge, std::span<const double> net) {
    end_ = reached(stage, ions, fixed_charge, net);
  }
  const SheetState& end() const { return end_; }
  /// Weighted sum of the rates of the charges at begin, middle and end of the step, [bottom,
  /// top][y][x]; the arguments are the weights.
  std::array<std::vector<double>, 2> weighed(double begin, double middle, double end) const;

private:
  SheetState reached(const SheetStage& stage, const IonState& ions,
                     std::span<const double> fixed_charge, std::span<const double> net) const;

  const ScaledGrid& grid_;
  const SheetElectrodes& electrodes_;
  SheetState begin_, middle_, end_;
  std::array<std::vector<double>, 2> start_; ///< charges from which the current stage starts
  double start_passed_ = 0;
};

} // namespace ionskin::electrochemistry
