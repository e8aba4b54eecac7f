// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/finite_layers/skin/cell_product.hpp"
#include "ionskin/laws/friction/cell_response.hpp"

#include <Eigen/Core>

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace ionskin::mechanics {

/// Forces on the contact cells [N], or mean displacements of them [m]: [3 cells], per cell normal
/// (pressing down), along x, along y.
using CellVector = std::vector<double>;

struct SliderStep;

/// Contact problem at one position of the slider: finds cell forces f with surface displacement u =
/// C f such that no cell is penetrated (u >= indentation - gap) or pulled, only touching cells
/// carry force, docs/model.md (4), and every cell obeys the friction law. With adhesion, touching
/// cells and cells near the slider may be pulled, docs/model.md (41).
struct ContactProblem {
  Eigen::MatrixXd compliance; ///< C, symmetric [m/N]; empty where `product` replaces it
  std::vector<double> area;   ///< of each cell [m2]
  /// Mean height of the slider's underside over each cell above its lowest point [m]; 0 for a flat
  /// slider.
  std::vector<double> gap;
  laws::Friction friction;
  /// Speed of slip of each cell as friction with a lag sees it [m/s]; empty: 0 everywhere.
  std::vector<double> lagged_speed = {};
  /// Compliance of a slider that yields, along x and y: part of C that is equal between any two
  /// cells [m/N].
  std::array<double, 2> common = {};
  /// Largest pull of each cell, prescribed whatever the openings [N]; empty: pulls follow the law
  /// of adhesion.
  std::vector<double> pull = {};
  /// C as products with vectors, without `common`; null where `compliance` is the matrix.
  std::shared_ptr<const finite_layers::CellProduct> product = {};
  /// Displacement of the cells by other sliders on the skin [m]; empty: none.
  CellVector by_others = {};

  int cells() const { return static_cast<int>(area.size()); }
  /// Compliance of a cell's component (0 normal, 1 along x, 2 along y) to its own force, without
  /// `common` [m/N]. In a tangential direction in which the skin is held (plane strain), it is the
  /// value of the other tangential direction.
  double own_compliance(int cell, int component) const;
  /// True if the skin is held along a component (plane strain), so that a force does not move it.
  bool held(int cell, int component) const;
  /// Distance between the slider's underside and a cell of the skin, positive when open [m].
  double opening(int cell, double indentation, const CellVector& surface) const;
  /// Largest pull of a cell by adhesion [N].
  double largest_pull(int cell) const;
  /// Decrease of a cell's pull with its opening [N/m]; 0 where pulls are prescribed.
  double pull_slope(int cell) const;
  /// Gap between a cell without forces and a slider that just touches the undeformed face [m];
  /// other sliders may displace the cell.
  double free_gap(int cell) const;
  /// Least `free_gap` of any cell [m]: the indentation at which the slider touches the skin.
  double least_free_gap() const;
  /// Displacement C f of the cells by forces f on them [m].
  CellVector own_displacement(const CellVector& force) const;
  /// Displacement of the cells by forces on them and by other sliders [m].
  CellVector surface_displacement(const CellVector& force) const;
  /// Largest tangential force of a cell along x that friction allows [N].
  /// @param normal_force of the cell [N]
  /// @param slip length of its slip in the step [m]
  /// @param time_step [s]
  double friction_limit(int cell, double normal_force, double slip, double time_step) const;
  /// Trial forces and other arguments with which `laws::cell_response` evaluates a cell.
  /// @param surface displacement of all cells [m]
  laws::CellTrial cell_trial(int cell, const SliderStep& step, double indentation,
                             const CellVector& force, const CellVector& surface) const;
  /// Largest tangential force of a cell along x at the end of a step in which it slipped [N].
  /// @param slip of the cell in the step, along x and y [m]
  double friction_limit_behind(int cell, double normal_force, const std::array<double, 2>& slip,
                               const SliderStep& step) const;
  /// Divides the slip of a cell in a step into an elastic and a lost part, see
  /// `laws::divided_slip`.
  /// @param slip of the cell in the step, along x and y [m]
  laws::SlipDivision divided_slip(int cell, double normal_force, const std::array<double, 2>& slip,
                                  const SliderStep& step) const;

private:
  double lagged_speed_of(int cell) const;
  laws::FrictionArguments arguments(int cell, double normal_force, const SliderStep& step) const;
};

/// Kind of load that presses the slider on the skin: a given indentation, or a given normal force.
enum class LoadKind { indentation, force };
/// Load on the slider.
struct SliderLoad {
  LoadKind kind = LoadKind::indentation;
  double value = 0; ///< indentation [m], or normal force on the meshed part of the skin [N]
};

/// Increment of the slider's motion, with the state of the skin before it.
struct SliderStep {
  SliderLoad load;                ///< at the end of the step
  std::array<double, 2> travel{}; ///< during the step, along x and y [m]
  double time_step = 0;           ///< [s]
  CellVector surface_before;      ///< displacement of the cells before the step [m]
  /// Elastic slip of each cell before the step; empty: none.
  std::vector<laws::ElasticSlip> elastic_before = {};
  /// Direction of sliding, for the limit of long sliding: all touching cells slip along it, and the
  /// step takes no time. Empty for an ordinary step.
  std::optional<std::array<double, 2>> sliding_direction = {};
  /// Travel of the slider at each cell by a turn about z, along x and y [m]; empty: no turn.
  std::vector<std::array<double, 2>> turn = {};

  laws::ElasticSlip elastic_slip_before(int cell) const {
    return elastic_before.empty() ? laws::ElasticSlip{}
                                  : elastic_before[static_cast<std::size_t>(cell)];
  }
};

/// Sum of the normal forces on all cells [N].
double total_normal_force(const CellVector& force);

/// Displacement of the slider relative to the skin at one cell during a step, along x and y [m].
/// @param surface displacement of all cells at the end of the step [m]
std::array<double, 2> slip_increment(const SliderStep& step, const CellVector& surface, int cell);

} // namespace ionskin::mechanics
