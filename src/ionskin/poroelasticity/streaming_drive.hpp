// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/history/core_history.hpp"
#include "ionskin/history/strain_projection.hpp"
#include "ionskin/poroelasticity/dragged_water.hpp"
#include "ionskin/poroelasticity/outside_water.hpp"
#include "ionskin/poroelasticity/pore_pressure.hpp"
#include "ionskin/poroelasticity/water_properties.hpp"

#include <array>
#include <span>
#include <string>
#include <vector>

namespace ionskin::poroelasticity {

/// State of the water at an instant; a resumed run continues from it.
struct WaterState {
  double time = 0; ///< [s]
  PressureState pressure;
  PressureState dragged; ///< by the ionic current, mean over the columns
};

/// Drive of the cations of a wet core beside the electric potential, docs/model.md (23): g = v L_s
/// P/V_T - theta (P - p_u)/M [thermal voltages over the valence], streaming (pressure drives water,
/// which drags cations) less dilution (water that arrives swells the core). The flux is J = -D
/// (grad N + N grad(v F phi/(R T) + g)). No part of it is fitted.
class StreamingDrive {
public:
  /// @param channel of the history: `undrained_pressure`, or `dilation`, of which the undrained
  ///   pressure is M_B times; both must outlive the drive
  /// @param x_edges, y_edges of the columns [m]
  /// @param levels where the drive is wanted, from 0 to the core's thickness [m]
  StreamingDrive(const Case& input, const history::CoreHistory& history,
                 const history::HistoryChannel& channel, const std::vector<double>& x_edges,
                 const std::vector<double>& y_edges, const std::vector<double>& levels);

  /// Moves the water to the first instant: the undrained response.
  void start(double time);
  /// The drive at an instant [levels][y][x], reached from the last accepted one with an undrained
  /// pressure that is linear in between.
  const std::vector<double>& evaluate(double time);
  /// Makes the instant that was evaluated last the one to go on from.
  /// @param cations above those at rest, per area at each level of the drive, means over the
  ///   columns [mol/m2]: the water that they have dragged; empty for ions at rest
  void accept(std::span<const double> cations);

  const WaterState& state() const { return accepted_; }
  /// Takes up a state that a run has left.
  void restore(const WaterState& state);

  /// Largest magnitude of the undrained drive v L_s p_u/V_T over the history.
  double largest() const { return largest_; }
  const WaterProperties& properties() const { return water_; }

  /// Parts of the voltage between the walls that balances the drive of the instant that was
  /// evaluated last, means over the columns: -L_s (P_top - P_bottom), and the dilution [V].
  double streaming_voltage() const;
  double dilution_voltage() const;
  /// Pressure on the faces that holds a prescribed compression [Pa]; 0 where none is held.
  double holding_pressure() const;
  /// Mean of P over the columns at a wall [Pa].
  double pressure_at_bottom() const;
  double pressure_at_top() const;
  /// Water that has left the core since the first instant, through each wall: all of it at the
  /// instant evaluated last, and the part that the ionic current has dragged at the last accepted
  /// one.
  Outflow left() const;
  const Outflow& dragged() const { return dragged_water_.left(); }
  /// Mean of P at the top wall above that at the bottom one which the dragged water makes and which
  /// the drive leaves out, at the last accepted instant [Pa].
  double dragged_pressure_difference() const { return dragged_water_.pressure_difference(); }
  /// P [Pa] and the swelling (P - p_u)/M [1] at the levels of the drive, [levels][y][x].
  std::vector<double> pressure_at_levels() const;
  std::vector<double> swelling_at_levels() const;
  /// Largest |P| [Pa] and |g| [1] of the instant that was evaluated last.
  double largest_pressure() const;
  double largest_drive() const;

  /// Pressure at the instant that was evaluated last, at the nodes of every column [z][y][x] [Pa].
  std::span<const double> pressure() const { return pressure_; }
  std::span<const double> undrained() const { return undrained_; }
  const std::vector<double>& nodes() const { return pore_pressure_.nodes(); }

private:
  /// Fills `undrained_` and what of it drives P less the steady pressure of the water outside.
  void load(double time);
  /// P from its departure from the steady pressure, and p_u with what a held compression adds.
  void unload(double time);
  void combine();
  std::size_t columns() const { return undrained_.size() / pore_pressure_.nodes().size(); }
  /// Mean pressure of the core as a whole [Pa].
  double mean_pressure() const;
  /// Mean over the columns of a field at the top wall minus that at the bottom one.
  double wall_difference(const std::vector<double>& field) const;

  WaterProperties water_;
  Relaxation relaxation_;
  double pressure_of_channel_; ///< p_u over the channel's value
  PorePressure pore_pressure_;
  history::StrainProjection projection_;
  history::LineOperator to_levels_;
  WaterWalls walls_;
  OutsideWater outside_;
  DraggedWater dragged_water_;
  double streaming_ = 0; ///< v L_s/V_T [1/Pa]
  double dilution_ = 0;  ///< theta/M [1/Pa]
  double volts_ = 0;     ///< V_T/v: what g counts in [V]
  double largest_ = 0;
  WaterState accepted_, tried_;
  std::vector<double> undrained_, driving_, pressure_, drive_, at_levels_;
};

} // namespace ionskin::poroelasticity
