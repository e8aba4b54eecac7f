// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/history/line_operators.hpp"
#include "ionskin/poroelasticity/pore_pressure.hpp"
#include "ionskin/poroelasticity/water_properties.hpp"

#include <span>
#include <vector>

namespace ionskin::poroelasticity {

/// Volumes through the walls of the core, per area of the skin and positive out of it [m].
struct Outflow {
  double bottom = 0, top = 0;
};

/// Water that has left the core through its walls, from how much its content has grown at the
/// nodes. The content is weighted with the pressure that one unit outside a wall would make, so
/// that no flux has to be differentiated: the manner of Ramo and Shockley, docs/model.md (27).
/// @param growth of the water at each node, per area [m]
Outflow outflow(const std::vector<double>& nodes, const WaterWalls& walls,
                std::span<const double> growth);

/// The water's side of Saxen's relation, docs/model.md (23): a cation drags n_d molecules of water,
/// so that a current i carries the volume flux L_s i. Where cations gather, so does their water; it
/// flows back through the core, or out through an open wall:
///   dP/dt = c_v d2P/dz2 + (c_v/K) n_d V_w dc/dt.
/// Means over the columns, between which this water moves as well but none is lost. The pressure
/// that it makes does not act on the ions again; how little that would be, it tells.
class DraggedWater {
public:
  /// @param volume that a mole of cations drags, n_d V_w [m3/mol]
  /// @param nodes of the pressure, as `wall_modes` takes them [m]
  /// @param levels of the ions, from 0 to the core's thickness [m]
  DraggedWater(const WaterProperties& water, double volume, std::vector<double> nodes,
               const WaterWalls& walls, const std::vector<double>& levels,
               const Relaxation& relaxation = {});

  /// State of equilibrium in which the cations rest and no water flows.
  PressureState rest() const;
  /// The state `duration` [s] after `begin`, the cations moving evenly in between.
  /// @param cations above those at rest, per area at each level, at the end [mol/m2]; empty: none
  void step(const PressureState& begin, double duration, std::span<const double> cations,
            PressureState& end);

  // Outflow of the state stepped to last.
  const Outflow& left() const { return left_; }
  /// P at the top wall above that at the bottom one [Pa].
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
