// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/poroelasticity/streaming_drive.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace ionskin::electrochemistry {

/// Unknowns of the ion transport in scaled units: concentration [c0/v], then potential [R T/(v F)],
/// each [z][y][x] with x fastest.
struct IonState {
  std::vector<double> values;

  IonState() = default;
  explicit IonState(std::size_t nodes) : values(2 * nodes, 0.0) {}
  std::size_t nodes() const { return values.size() / 2; }
  std::span<double> concentration() { return {values.data(), nodes()}; }
  std::span<double> potential() { return {values.data() + nodes(), nodes()}; }
  std::span<const double> concentration() const { return {values.data(), nodes()}; }
  std::span<const double> potential() const { return {values.data() + nodes(), nodes()}; }
};

/// State of the solver between two time steps: all that the next step and the choice of its length
/// depend on.
struct TransportState {
  IonState ions;
  /// Rates of change at the end of the last step [1/relaxation time]: of concentration minus
  /// released ions, then of potential, [2 nodes].
  std::vector<double> rate;
  double next_step = 0;    ///< length of the next step to try [s]
  double charge_scale = 0; ///< largest charge per area so far [F c0 lambda], by `ChargeNorm`
  /// State of the water; nothing for laws that do not move water.
  std::optional<poroelasticity::WaterState> memory;
  /// Scaled charges of the conductors of cut faces (`ConductorCharges`), or the packed state of
  /// metal with sheet resistances (`SheetState::packed`); empty where each electrode is one
  /// equipotential conductor.
  std::vector<double> electrode_charge{};
};

} // namespace ionskin::electrochemistry
