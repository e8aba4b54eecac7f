// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/poroelasticity/line_modes.hpp"
#include "ionskin/poroelasticity/relaxation.hpp"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace ionskin::poroelasticity {

/// Where the water stands: amplitudes of the modes [Pa].
struct PressureState {
  /// Of what decays in P, the water potential over the molar volume of water: [terms][z][y][x]
  std::vector<double> pressure;
  std::vector<double> undrained; ///< p_u, what it would be if no water moved: [z][y][x]
};

/// Water potential P in the core under a load whose undrained pore pressure p_u is given,
/// docs/model.md (22):
///   dP/dt = c_v (d2/dx2 + d2/dy2 + d2/dz2) P + dp_u/dt,
/// sealed at the sides, with P = 0 outside the walls. Every mode of the core (cosines along
/// x and y, eigenmodes of linear elements through the thickness) decays on its own, which is solved
/// exactly for a p_u linear in time over a step: no limit on the step, and no water lost between
/// sealed walls. Of a core whose stress relaxes, each mode is a sum of such decays,
/// docs/model.md (76), and p_u is that of its elastic constants at the first instant.
/// Consolidation: Biot 1941, doi 10.1063/1.1712886.
class PorePressure {
public:
  /// @param columns along x and y; widths of a column [m]
  /// @param nodes through the thickness, from 0 [m]
  /// @param held_share of the mean of P that comes back as p_u, docs/model.md (75)
  PorePressure(const std::array<std::size_t, 2>& columns, const std::array<double, 2>& widths,
               std::vector<double> nodes, const WaterWalls& walls, double consolidation_coefficient,
               double held_share = 0, const Relaxation& relaxation = {});

  const std::vector<double>& nodes() const { return nodes_; }
  std::size_t values() const { return x_.size * y_.size * z_.size; }
  /// Of `PressureState::pressure`.
  std::size_t amplitudes() const { return rate_.size(); }

  /// At the first instant: the undrained response.
  /// @param undrained p_u at the nodes of every column [z][y][x] [Pa]
  void start(std::span<const double> undrained, PressureState& state);

  /// The state `duration` [s] after `begin`, with p_u linear in between.
  /// @param undrained p_u at the end [z][y][x] [Pa]
  void step(const PressureState& begin, double duration, std::span<const double> undrained,
            PressureState& end);

  /// P at the nodes of every column, [z][y][x] [Pa]; `out` is resized.
  void pressure(const PressureState& state, std::vector<double>& out);
  /// The undrained pressure that would have let in as much water: p_u where nothing relaxes.
  void undrained(const PressureState& state, std::vector<double>& out);

private:
  void to_modes(std::span<const double> field, std::vector<double>& modes);
  void from_modes(const std::vector<double>& modes, std::vector<double>& field);
  /// Sum of the terms of each mode.
  void sum_terms(const PressureState& state, const std::vector<double>& weights,
                 std::vector<double>& modes) const;

  LineModes x_, y_, z_;
  std::vector<double> nodes_;
  std::vector<double> rate_;                               ///< of each decay [terms][z][y][x] [1/s]
  std::vector<double> pressure_weight_, undrained_weight_; ///< likewise
  double undrained_directly_ = 1;
  std::vector<double> sum_;            ///< scratch
  std::vector<double> first_, second_; ///< scratch, so that no step allocates
};

} // namespace ionskin::poroelasticity
