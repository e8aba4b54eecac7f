// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/poroelasticity/line_modes.hpp"
#include "ionskin/poroelasticity/relaxation.hpp"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace ionskin::poroelasticity {

/// State of the water in the core at one instant, as amplitudes of the modes of `PorePressure`
/// [Pa].
struct PressureState {
  /// Amplitudes of the decaying terms whose weighted sum is the pore pressure P (water potential
  /// over the molar volume of water), [term][z][y][x] by mode.
  std::vector<double> pressure;
  /// Amplitudes of the undrained pressure p_u, the pore pressure if no water moved, [z][y][x] by
  /// mode.
  std::vector<double> undrained;
};

/// Solver of the diffusion of pore water: pore pressure P in the core under a load whose undrained
/// pore pressure p_u is given, docs/model.md (22):
///   dP/dt = c_v (d2/dx2 + d2/dy2 + d2/dz2) P + dp_u/dt,
/// with sealed sides and P = 0 outside the walls. Every mode of the core (cosines along x and y,
/// eigenmodes of quadratic elements through the thickness) decays independently and is solved
/// exactly for a p_u that is linear in time over a step. So the time step has no limit, and no
/// water is lost between sealed walls. If the stress of the core relaxes, each mode is a sum of
/// such decaying terms, docs/model.md (76), and p_u is computed from the elastic constants at the
/// first instant. Consolidation: Biot 1941, doi 10.1063/1.1712886.
class PorePressure {
public:
  /// @param columns number of lateral columns along x and y
  /// @param widths of a column along x and y [m]
  /// @param nodes heights of the nodes of quadratic elements, from 0 at the bottom [m]
  /// @param consolidation_coefficient c_v [m2/s]
  /// @param held_share share of the mean of P that adds to p_u while a compression is held,
  ///   docs/model.md (75) [1]; 0 otherwise
  /// @param relaxation of the core's stress; the default does not relax
  PorePressure(const std::array<std::size_t, 2>& columns, const std::array<double, 2>& widths,
               std::vector<double> nodes, const WaterWalls& walls, double consolidation_coefficient,
               double held_share = 0, const Relaxation& relaxation = {});

  const std::vector<double>& nodes() const { return nodes_; }
  std::size_t values() const { return x_.size * y_.size * z_.size; }
  /// Number of amplitudes in `PressureState::pressure`.
  std::size_t amplitudes() const { return rate_.size(); }

  /// Sets the state at the first instant, at which P = p_u: no water has moved yet.
  /// @param undrained p_u at the nodes of every column [z][y][x] [Pa]
  /// @param state receives the amplitudes
  void start(std::span<const double> undrained, PressureState& state);

  /// Advances the state by one time step, with p_u linear in time over the step.
  /// @param begin state at the start of the step
  /// @param duration of the step [s]
  /// @param undrained p_u at the end of the step [z][y][x] [Pa]
  /// @param end receives the state at the end of the step
  void step(const PressureState& begin, double duration, std::span<const double> undrained,
            PressureState& end);

  /// Computes P at the nodes of every column from a state.
  /// @param out receives P [z][y][x] [Pa]; resized
  void pressure(const PressureState& state, std::vector<double>& out);
  /// Computes the effective undrained pressure, at which P - `out` is M times the swelling; without
  /// relaxation it is p_u.
  /// @param out receives the pressure [z][y][x] [Pa]; resized
  void undrained(const PressureState& state, std::vector<double>& out);

private:
  void to_modes(std::span<const double> field, std::vector<double>& modes);
  void from_modes(const std::vector<double>& modes, std::vector<double>& field);
  /// Sums the decaying terms of each mode with the given weights [term][z][y][x].
  void sum_terms(const PressureState& state, const std::vector<double>& weights,
                 std::vector<double>& modes) const;

  LineModes x_, y_, z_;
  std::vector<double> nodes_;
  std::vector<double> rate_; ///< decay rates [term][z][y][x] [1/s]
  /// Weights of the terms in P and in the effective undrained pressure [term][z][y][x] [1].
  std::vector<double> pressure_weight_, undrained_weight_;
  double undrained_directly_ = 1;
  std::vector<double> sum_;            ///< scratch
  std::vector<double> first_, second_; ///< scratch, so that no step allocates
};

} // namespace ionskin::poroelasticity
