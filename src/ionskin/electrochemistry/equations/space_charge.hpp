// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/electrochemistry/equations/steric_excess.hpp"
#include "ionskin/electrochemistry/grid/scaled_grid.hpp"
#include "ionskin/history/core_history.hpp"
#include "ionskin/history/strain_projection.hpp"
#include "ionskin/laws/coupling/coupling_law.hpp"
#include "ionskin/poroelasticity/streaming_drive.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace ionskin::electrochemistry {

/// Effect of the history on the ions by the coupling law of the case: the fixed part of the space
/// charge rho = F (v c - cf), docs/model.md (13), or a drive of the cations beside the potential.
class FixedCharge {
public:
  FixedCharge(const Case& input, const history::CoreHistory& history, const TransportGrid& grid,
              const ScaledGrid& scaled);

  /// Goes to the first instant [s].
  void start(double time);
  /// Moves to an instant [s] from the last accepted one. Throws SolverError when cf becomes
  /// negative there, or when the law releases more ions than the steric ion model has room for.
  void evaluate(double time);
  /// Makes the instant evaluated last the one to go on from, which matters to laws with a memory.
  /// @param concentration of the cations there, scaled [nodes]
  void accept(std::span<const double> concentration);
  /// The memory of the law at the last accepted instant; empty without one.
  std::optional<poroelasticity::WaterState> memory() const;
  void restore(const std::optional<poroelasticity::WaterState>& memory);

  std::span<const double> shear() const { return shear_; } ///< per control volume [1]
  std::span<const double> ratio() const { return ratio_; } ///< cf / c0 [1]
  /// Added to the scaled potential wherever that drives the cations [nodes]; empty for none.
  std::span<const double> drive() const { return drive_; }
  /// Drive of the water under a law that moves it, at the instant evaluated last; nullptr
  /// otherwise.
  const poroelasticity::StreamingDrive* water() const { return water_ ? &*water_ : nullptr; }
  /// Largest departure of cf / c0 from 1, or largest drive, that the history can make [1].
  double largest_coupling() const { return largest_coupling_; }
  /// True if the charge of the core changes with the shear.
  bool makes_net_charge() const { return traits_.makes_net_charge; }
  /// True if the law adds a mobile ion for every fixed charge it adds.
  bool releases_ions() const { return traits_.releases_ions; }

private:
  void check_sign(double time) const;
  void check_room(double time) const;
  /// "6000 mol/m3 at t = 0.5 s, x = ..., where the shear is 0.1": a node's fixed charge.
  std::string describe(std::size_t node, double time) const;

  Coupling coupling_;
  laws::CouplingTraits traits_;
  laws::Coupling law_;
  double reference_concentration_;
  double resting_concentration_; ///< of the cations [mol/m3]
  std::optional<StericExcess> excess_;
  TransportGrid grid_;
  const ScaledGrid& scaled_;
  std::optional<history::StrainProjection> projection_; ///< of the shear, where there is one
  std::optional<poroelasticity::StreamingDrive> water_;
  double largest_coupling_ = 0;
  std::vector<double> shear_, ratio_;
  std::vector<double> cations_; ///< per level, scratch
  std::span<const double> drive_;
};

/// Evaluates the fixed charge at every sample of the history, between which it is linear in time at
/// rest. For checks before a long run; throws what `FixedCharge::evaluate` throws.
void check_fixed_charge(const Case& input, const history::CoreHistory& history);

} // namespace ionskin::electrochemistry
