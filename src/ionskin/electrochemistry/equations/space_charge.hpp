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

/// Effect of the strain history on the ions by the coupling law of the case, at one instant: the
/// fixed charge cf of the space charge rho = F (v c - cf), docs/model.md (13), or a drive of the
/// cations beside the potential.
class FixedCharge {
public:
  /// @param history strain history; must outlive this
  /// @param grid solved part of the transport grid [m]
  /// @param scaled the same part in Debye lengths; must outlive this
  FixedCharge(const Case& input, const history::CoreHistory& history, const TransportGrid& grid,
              const ScaledGrid& scaled);

  /// Starts at the first instant [s] of the history.
  void start(double time);
  /// Evaluates shear, fixed charge and drive at an instant [s]; water moves there from the last
  /// accepted instant. Throws SolverError when cf becomes negative, or when the law releases more
  /// ions than the steric ion model has room for.
  void evaluate(double time);
  /// Accepts the instant evaluated last as the one from which water moves on; other laws have no
  /// memory.
  /// @param concentration of the cations at that instant [c0/v], [nodes]
  void accept(std::span<const double> concentration);
  /// State of the water at the last accepted instant, which `restore` sets; nothing for laws
  /// without water.
  std::optional<poroelasticity::WaterState> memory() const;
  void restore(const std::optional<poroelasticity::WaterState>& memory);

  /// Shear strain gamma of every control volume [1], [nodes]; 0 without a shear channel.
  std::span<const double> shear() const { return shear_; }
  std::span<const double> ratio() const { return ratio_; } ///< fixed charge cf / c0 [1], [nodes]
  /// Drive g of the cations, which their flux sees added to the scaled potential [nodes]; empty for
  /// none.
  std::span<const double> drive() const { return drive_; }
  /// Half of the net charge per area below every column that the law has made, which returns
  /// through the ground [y][x].
  std::vector<double> net_of_columns() const;
  /// Water and its drive at the instant evaluated last; nullptr for laws that do not move water.
  const poroelasticity::StreamingDrive* water() const { return water_ ? &*water_ : nullptr; }
  /// Largest departure of cf / c0 from 1, or largest drive g, that the history can make [1].
  double largest_coupling() const { return largest_coupling_; }
  /// True if the law releases a mobile ion for every fixed charge that it adds.
  bool releases_ions() const { return traits_.releases_ions; }

private:
  void check_sign(double time) const;
  void check_room(double time) const;
  /// Describes the fixed charge at a node, for messages: "6000 mol/m3 at t = 0.5 s, x = ..., where
  /// the shear is 0.1".
  std::string describe(std::size_t node, double time) const;

  Coupling coupling_;
  laws::CouplingTraits traits_;
  laws::Coupling law_;
  double reference_concentration_;
  double resting_concentration_; ///< of the cations [mol/m3]
  std::optional<StericExcess> excess_;
  TransportGrid grid_;
  const ScaledGrid& scaled_;
  /// Projection of the shear channel; nothing where the history has none.
  std::optional<history::StrainProjection> projection_;
  std::optional<poroelasticity::StreamingDrive> water_;
  double largest_coupling_ = 0;
  std::vector<double> shear_, ratio_;
  std::vector<double> cations_; ///< scratch, per z level [mol/m2]
  std::span<const double> drive_;
};

/// Checks the fixed charge at every sample of a strain history before a long run. Between samples
/// it is linear in time while the slider rests. Throws SolverError as `FixedCharge::evaluate` does.
void check_fixed_charge(const Case& input, const history::CoreHistory& history);

} // namespace ionskin::electrochemistry
