// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/history/core_history.hpp"
#include "ionskin/history/strain_projection.hpp"
#include "ionskin/poroelasticity/pore_pressure.hpp"
#include "ionskin/poroelasticity/water_properties.hpp"

#include <span>
#include <string>
#include <vector>

namespace ionskin::poroelasticity {

/// Where the water stands at an instant; what a resumed run takes up.
struct WaterState {
  double time = 0; ///< [s]
  PressureState pressure;
};

/// What drives the cations of a wet core beside the electric potential:
///   g = v L_s P/V_T - theta (P - p_u)/M   [thermal voltages over the valence],
/// streaming (pressure drives water, which drags cations) less dilution (water that arrives swells
/// the core). The flux is J = -D (grad N + N grad(v F phi/(R T) + g)), see docs/model.md. No part
/// of it is fitted.
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
  void accept() { accepted_ = tried_; }

  const WaterState& state() const { return accepted_; }
  /// Takes up a state that a run has left.
  void restore(const WaterState& state);

  /// Largest magnitude of the undrained drive v L_s p_u/V_T over the history.
  double largest() const { return largest_; }
  const WaterProperties& properties() const { return water_; }

  /// Of the instant that was evaluated last, at the nodes of every column [z][y][x] [Pa].
  std::span<const double> pressure() const { return pressure_; }
  std::span<const double> undrained() const { return undrained_; }
  const std::vector<double>& nodes() const { return pore_pressure_.nodes(); }

private:
  void load(double time);
  void combine();

  WaterProperties water_;
  double pressure_of_channel_; ///< p_u over the channel's value
  PorePressure pore_pressure_;
  history::StrainProjection projection_;
  history::LineOperator to_levels_;
  double streaming_ = 0; ///< v L_s/V_T [1/Pa]
  double dilution_ = 0;  ///< theta/M [1/Pa]
  double largest_ = 0;
  WaterState accepted_, tried_;
  std::vector<double> undrained_, pressure_, drive_, at_levels_;
};

} // namespace ionskin::poroelasticity
