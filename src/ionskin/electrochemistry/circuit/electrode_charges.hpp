// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/electrochemistry/circuit/wall_electrodes.hpp"

#include <span>
#include <vector>

namespace ionskin::electrochemistry {

/// Charges of the conductors of cut faces while a run advances, scaled [F c0 lambda times the area
/// of a column]. Each conductor obeys d(Q - n + C u)/dt = -u/R, docs/model.md (63), where n, half
/// of the net charge that the coupling law makes in the core at the conductor, returns through the
/// ground. The time integrator advances the charges Q - n + C u like the ions, which conserves them
/// to rounding.
class ElectrodeCharges {
public:
  /// @param electrodes must outlive this
  explicit ElectrodeCharges(const WallElectrodes& electrodes);

  const WallElectrodes& electrodes() const { return electrodes_; }
  /// Connects the conductors to these circuits from now on, one entry for each; an empty entry
  /// holds a conductor at the ground.
  void connect(std::vector<std::optional<ScaledAdmittance>> circuits);
  const std::vector<std::optional<ScaledAdmittance>>& circuits() const { return circuits_; }

  /// Computes the rate -u/R at which each conductor's charge changes; 0 for a conductor held at the
  /// ground.
  /// @param potentials u of every conductor [R T/(v F)]
  std::vector<double> rates(std::span<const double> potentials) const;
  /// Makes the equations of the circuits in an implicit stage.
  /// @param start charges Q - n + C u from which the stage starts, of every conductor
  /// @param implicit implicit part of the time step [relaxation times]
  /// @param net n of every conductor at the instant of the stage
  ElectrodeStage stage(std::span<const double> start, double implicit,
                       std::span<const double> net) const;
  /// True if the ground holds the conductor.
  bool holds(std::size_t conductor) const { return !circuits_[conductor]; }
  /// Scaled capacitance C of the conductor's circuit; 0 if the ground holds the conductor.
  double capacitance(std::size_t conductor) const {
    return circuits_[conductor] ? circuits_[conductor]->capacitance : 0.0;
  }

private:
  const WallElectrodes& electrodes_;
  std::vector<std::optional<ScaledAdmittance>> circuits_;
};

} // namespace ionskin::electrochemistry
