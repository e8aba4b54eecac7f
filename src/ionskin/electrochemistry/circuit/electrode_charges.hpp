// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/electrochemistry/circuit/wall_electrodes.hpp"

#include <span>
#include <vector>

namespace ionskin::electrochemistry {

/// Charges of the conductors of cut faces while a run advances, all scaled. For each, d(Q - n
/// + C u)/dt = -u/R, docs/model.md (63), where n is half of the net charge that the coupling law
/// makes below it, which returns through the ground. The charges Q - n + C u are advanced like the
/// ions, and conserved to rounding.
class ElectrodeCharges {
public:
  explicit ElectrodeCharges(const WallElectrodes& electrodes);

  const WallElectrodes& electrodes() const { return electrodes_; }
  /// The circuits from now on; nothing holds a conductor at the ground.
  void connect(std::vector<std::optional<ScaledAdmittance>> circuits);
  const std::vector<std::optional<ScaledAdmittance>>& circuits() const { return circuits_; }

  /// -u/R of every conductor, 0 where it is held.
  std::vector<double> rates(std::span<const double> potentials) const;
  /// Implicit stage that starts from the given charges.
  /// @param implicit part of the step
  /// @param net n of every conductor
  ElectrodeStage stage(std::span<const double> start, double implicit,
                       std::span<const double> net) const;
  bool holds(std::size_t conductor) const { return !circuits_[conductor]; }
  double capacitance(std::size_t conductor) const {
    return circuits_[conductor] ? circuits_[conductor]->capacitance : 0.0;
  }

private:
  const WallElectrodes& electrodes_;
  std::vector<std::optional<ScaledAdmittance>> circuits_;
};

} // namespace ionskin::electrochemistry
