// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/poroelasticity/streaming_drive.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace ionskin::electrochemistry {

/// Scaled unknowns: concentration v c / c0, then potential v F phi / (R T), each [z][y][x].
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

/// State from which a time step starts, with all that the choice of the step depends on.
struct TransportState {
  IonState ions;
  /// Rate of change at the end of the last step [1/scaled time]: of concentration minus released
  /// ions, then of potential.
  std::vector<double> rate;
  double next_step = 0;                             ///< length to try next [s]
  double charge_scale = 0;                          ///< largest charge so far; see ChargeNorm
  std::optional<poroelasticity::WaterState> memory; ///< of laws that move water
  /// Charges of the conductors of cut faces, see ElectrodeCharges; empty for one conductor.
  std::vector<double> electrode_charge{};
};

} // namespace ionskin::electrochemistry
