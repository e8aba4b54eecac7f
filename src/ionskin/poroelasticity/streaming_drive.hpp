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

/// State of the water at one instant. Checkpoints store it, so that a resumed run continues from
/// it.
struct WaterState {
  double time = 0;        ///< [s]
  PressureState pressure; ///< pressure caused by the load
  PressureState dragged;  ///< pressure caused by the ionic current, mean over the columns
};

/// Drive of the cations in a wet core in addition to the electric potential, docs/model.md (23):
///   g = v L_s P/V_T - theta (P - p_u)/M [1], in thermal voltages over the valence.
/// The first term is streaming (pressure drives water, which drags cations), the second is dilution
/// (arriving water swells the core). The flux of the cations is
/// J = -D (grad c + c grad(v F phi/(R T) + g)). No coefficient is fitted. The class also solves for
/// the pore pressure P, step by step: `evaluate` tries an instant, `accept` continues from it.
class StreamingDrive {
public:
  /// @param history strain history
  /// @param channel channel of the history that drives the water: `undrained_pressure` p_u [Pa], or
  ///   `dilation` [1], where p_u is M_B times the channel; both must outlive this object
  /// @param x_edges,y_edges edges of the lateral columns, equally spaced [m]
  /// @param levels heights at which the drive is computed, from 0 to the thickness of the core [m]
  StreamingDrive(const Case& input, const history::CoreHistory& history,
                 const history::HistoryChannel& channel, const std::vector<double>& x_edges,
                 const std::vector<double>& y_edges, const std::vector<double>& levels);

  /// Sets the accepted state to the first instant [s], at which P = p_u: no water has moved yet.
  void start(double time);
  /// Advances the water from the last accepted instant to `time` [s], with p_u linear in between,
  /// and returns the drive g there, [level][y][x] [1]. The reference is valid until the next call.
  const std::vector<double>& evaluate(double time);
  /// Accepts the instant that was evaluated last: the next step starts there.
  /// @param cations amount of cations at each level above the amount at rest, per area of the skin,
  ///   mean over the columns [mol/m2], from which the dragged water follows; empty for ions at rest
  void accept(std::span<const double> cations);

  const WaterState& state() const { return accepted_; }
  /// Continues from a state that an earlier run stored. Throws UserError when its sizes do not fit
  /// this grid.
  void restore(const WaterState& state);

  /// Upper bound of the undrained drive v L_s p_u/V_T over the history, in magnitude, with the
  /// largest pressure outside added to p_u [1].
  double largest() const { return largest_; }
  const WaterProperties& properties() const { return water_; }

  /// Voltage, top against bottom, that balances streaming at the instant evaluated last, mean over
  /// the columns: -L_s (P_top - P_bottom) [V].
  double streaming_voltage() const;
  /// Voltage, top against bottom, that balances dilution at the instant evaluated last, mean over
  /// the columns [V].
  double dilution_voltage() const;
  /// Pressure on the faces that holds a prescribed compression, at the instant evaluated last [Pa];
  /// 0 if none is held.
  double holding_pressure() const;
  /// Mean of P over the columns at the bottom wall, at the instant evaluated last [Pa].
  double pressure_at_bottom() const;
  /// Mean of P over the columns at the top wall, at the instant evaluated last [Pa].
  double pressure_at_top() const;
  /// All water that has left the core through each wall since the first instant, per area of the
  /// skin, at the instant evaluated last [m].
  Outflow left() const;
  /// Water dragged by the ionic current that has left the core through each wall, a part of `left`,
  /// per area of the skin, at the last accepted instant [m].
  const Outflow& dragged() const { return dragged_water_.left(); }
  /// Pressure difference between the walls (top minus bottom) caused by the dragged water, mean
  /// over the columns, at the last accepted instant [Pa]. The drive leaves this pressure out.
  double dragged_pressure_difference() const { return dragged_water_.pressure_difference(); }
  /// P at the levels of the drive, at the instant evaluated last, [level][y][x] [Pa].
  std::vector<double> pressure_at_levels() const;
  /// Swelling (P - p_u)/M at the levels of the drive, at the instant evaluated last, [level][y][x]
  /// [1].
  std::vector<double> swelling_at_levels() const;
  /// Largest |P| in the core at the instant evaluated last [Pa].
  double largest_pressure() const;
  /// Largest |g| in the core at the instant evaluated last [1].
  double largest_drive() const;

  /// P at the nodes of every column, at the instant evaluated last, [z][y][x] [Pa].
  std::span<const double> pressure() const { return pressure_; }
  /// Undrained pressure p_u (with relaxation, the effective one) at the nodes of every column, at
  /// the instant evaluated last, [z][y][x] [Pa].
  std::span<const double> undrained() const { return undrained_; }
  /// Heights of the pressure nodes above the bottom of the core [m].
  const std::vector<double>& nodes() const { return pore_pressure_.nodes(); }

private:
  /// Evaluates the history: fills `undrained_` with p_u, and `driving_` with p_u minus the steady
  /// pressure of the water outside.
  void load(double time);
  /// Adds the steady pressure of the water outside to P, and the effect of relaxation and of a held
  /// compression to p_u.
  void unload(double time);
  /// Computes the drive g from P and p_u.
  void combine();
  std::size_t columns() const { return undrained_.size() / pore_pressure_.nodes().size(); }
  /// Mean of P over the whole core [Pa].
  double mean_pressure() const;
  /// Mean over the columns of a field at the top wall minus its mean at the bottom wall.
  double wall_difference(const std::vector<double>& field) const;

  WaterProperties water_;
  Relaxation relaxation_;
  double pressure_of_channel_; ///< p_u over the value of the channel: M_B [Pa], or 1
  PorePressure pore_pressure_;
  history::StrainProjection projection_;
  history::LineOperator to_levels_;
  WaterWalls walls_;
  OutsideWater outside_;
  double passed_before_; ///< `outside_.passed` at the first instant of the history [m]
  DraggedWater dragged_water_;
  double streaming_ = 0; ///< v L_s/V_T [1/Pa]
  double dilution_ = 0;  ///< theta/M [1/Pa]
  double volts_ = 0;     ///< V_T/v, voltage of one unit of g [V]
  double largest_ = 0;
  WaterState accepted_, tried_;
  std::vector<double> undrained_, driving_, pressure_, drive_, at_levels_;
};

} // namespace ionskin::poroelasticity
