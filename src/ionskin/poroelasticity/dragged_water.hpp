// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/history/line_operators.hpp"
#include "ionskin/poroelasticity/pore_pressure.hpp"
#include "ionskin/poroelasticity/water_properties.hpp"

#include <span>
#include <vector>

namespace ionskin::poroelasticity {

/// Volumes of water that have left the core through its bottom and top walls, per area of the skin
/// [m]; negative where water has entered.
struct Outflow {
  double bottom = 0, top = 0;
};

/// Computes the water that has left the core through each wall from the increase of the water
/// content at the nodes. The increase is weighted with the steady pressure that a unit pressure
/// outside the wall would cause, so that no flux has to be differentiated (as in the theorem of
/// Ramo and Shockley, docs/model.md (27)).
/// @param nodes heights through the core, as `wall_modes` takes them [m]
/// @param growth increase of the water volume at each node, per area of the skin [m]
Outflow outflow(const std::vector<double>& nodes, const WaterWalls& walls,
                std::span<const double> growth);

/// Pore pressure caused by the water that the ionic current drags (the reciprocal effect of
/// streaming by Saxen's relation, docs/model.md (23)): a cation drags n_d molecules of water, so a
/// current density i carries the volume flux L_s i. Where cations accumulate, so does their water,
/// which flows back through the core or out through an open wall:
///   dP/dt = c_v d2P/dz2 + (c_v/K) n_d V_w dc/dt.
/// The class solves for the mean over the skin. The pressure does not act back on the ions;
/// `pressure_difference` shows how small that effect would be.
class DraggedWater {
public:
  /// @param volume of water that a mole of cations drags, n_d V_w [m3/mol]
  /// @param nodes heights of the pressure nodes, as `wall_modes` takes them [m]
  /// @param levels z levels of the ion grid, from 0 to the thickness of the core [m]
  /// @param relaxation of the core's stress; the default does not relax
  DraggedWater(const WaterProperties& water, double volume, std::vector<double> nodes,
               const WaterWalls& walls, const std::vector<double>& levels,
               const Relaxation& relaxation = {});

  /// State at rest: equilibrium concentration of the cations and no pressure.
  PressureState rest() const;
  /// Advances the water by one time step, with concentrations linear in time over the step.
  /// @param begin state at the start of the step
  /// @param duration of the step [s]
  /// @param cations amount of cations at each z level above the amount at rest, per area of the
  ///   skin, at the end of the step [mol/m2]; empty for ions at rest
  /// @param end receives the state at the end of the step
  void step(const PressureState& begin, double duration, std::span<const double> cations,
            PressureState& end);

  /// Dragged water that has left the core since it was at rest, at the end of the last step.
  const Outflow& left() const { return left_; }
  /// P at the top wall minus P at the bottom wall, at the end of the last step [Pa].
  double pressure_difference() const { return pressure_.back() - pressure_.front(); }

private:
  double volume_, modulus_; ///< modulus: c_v/K [Pa]
  double held_share_;
  std::vector<double> nodes_, lengths_;
  WaterWalls walls_;
  history::LineOperator to_levels_;
  PorePressure water_;
  bool relaxes_;
  std::vector<double> brought_, load_, pressure_;
  Outflow left_;
};

} // namespace ionskin::poroelasticity
