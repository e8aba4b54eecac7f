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

/// Forces on, or mean displacements of, the contact cells: [3 cells], per cell normal (pressing
/// down), along x, along y.
using CellVector = std::vector<double>;

struct SliderStep;

/// Dense contact problem of one slider position: find cell forces f with surface displacement w = C
/// f such that no cell is penetrated (w >= indentation - gap) or pulled, only touching cells carry
/// force, docs/model.md (4), and every cell obeys the friction law. Where that adheres, cells that
/// touch may be pulled, and so are those near the slider, docs/model.md (41).
struct ContactProblem {
  Eigen::MatrixXd compliance; ///< C, symmetric; empty where `product` stands for it [m/N]
  std::vector<double> area;   ///< of the cells [m2]
  /// Mean height of the slider's underside over each cell above its lowest point [m]; 0 for a flat
  /// slider.
  std::vector<double> gap;
  laws::Friction friction;
  /// Speed of slip that friction follows with its lag [m/s]; empty where all cells rest.
  std::vector<double> lagged_speed = {};
  /// Part of the compliance that is the same between any two cells, along x and y: of a slider that
  /// yields [m/N].
  std::array<double, 2> common = {};
  /// Pulls that stand for those of the adhesion, whatever the openings [N]; empty: by the law.
  std::vector<double> pull = {};
  /// Null, or C without a matrix, less `common`.
  std::shared_ptr<const finite_layers::CellProduct> product = {};
  /// Displacement of the cells by other sliders on the skin; empty without [m].
  CellVector by_others = {};

  int cells() const { return static_cast<int>(area.size()); }
  /// Compliance of one component against its own force, less `common`; in a direction in which the
  /// skin is held (plane strain) that of the other tangential direction.
  double own_compliance(int cell, int component) const;
  /// True if the skin is held along a component, so that its force does not move it.
  bool held(int cell, int component) const;
  /// Distance of the slider's underside from a cell of the skin [m].
  double opening(int cell, double indentation, const CellVector& surface) const;
  /// Largest pull of a cell [N], and by how much it falls with the opening [N/m].
  double largest_pull(int cell) const;
  double pull_slope(int cell) const;
  /// Gap over the skin as it is without forces on the cells [m], and the least of any cell.
  double free_gap(int cell) const;
  double least_free_gap() const;
  /// Displacement C f of the cells by forces on them [m].
  CellVector own_displacement(const CellVector& force) const;
  /// Displacement of the cells by forces on them and by other sliders [m].
  CellVector surface_displacement(const CellVector& force) const;
  /// Largest tangential force of a cell under a normal force, along x, and its derivative [N], [1].
  double friction_limit(int cell, double normal_force, double slip, double time_step) const;
  double friction_limit_slope(int cell, double normal_force, double slip, double time_step) const;
  /// Before the equations of a cell, laws::cell_response. @param surface C f [m]
  laws::CellTrial cell_trial(int cell, const SliderStep& step, double indentation,
                             const CellVector& force, const CellVector& surface) const;
  /// Largest tangential force of a cell that slipped in a step, along x [N].
  double friction_limit_behind(int cell, double normal_force, const std::array<double, 2>& slip,
                               const SliderStep& step) const;
  /// Parts of its slip, as laws::divided_slip.
  laws::SlipDivision divided_slip(int cell, double normal_force, const std::array<double, 2>& slip,
                                  const SliderStep& step) const;

private:
  double lagged_speed_of(int cell) const;
  laws::FrictionArguments arguments(int cell, double normal_force, const SliderStep& step) const;
};

/// Load that presses the slider on the skin: a given indentation, or a given force that the
/// indentation has to carry.
enum class LoadKind { indentation, force };
struct SliderLoad {
  LoadKind kind = LoadKind::indentation;
  double value = 0; ///< [m], or [N] on the meshed part of the skin
};

/// One increment of the slider's motion.
struct SliderStep {
  SliderLoad load;                ///< at the end of the step
  std::array<double, 2> travel{}; ///< during the step, x and y [m]
  double time_step = 0;           ///< [s]
  CellVector surface_before;      ///< surface displacement at its start [m]
  /// Elastic slip of the cells at its start; empty without.
  std::vector<laws::ElasticSlip> elastic_before = {};
  /// Direction of the limit of long sliding, in which all cells that touch slip along it, and the
  /// step takes no time; empty for a step like others.
  std::optional<std::array<double, 2>> sliding_direction = {};
  /// Travel of each cell of the slider by its turn about z; empty without [m].
  std::vector<std::array<double, 2>> turn = {};

  laws::ElasticSlip elastic_slip_before(int cell) const {
    return elastic_before.empty() ? laws::ElasticSlip{}
                                  : elastic_before[static_cast<std::size_t>(cell)];
  }
};

/// Sum of the normal forces [N].
double total_normal_force(const CellVector& force);
/// True when no cell is pulled by more than its adhesion.
bool free_of_tension(const ContactProblem& problem, const CellVector& force);

/// Displacement of the slider relative to the skin at one cell during a step [m].
std::array<double, 2> slip_increment(const SliderStep& step, const CellVector& surface, int cell);

} // namespace ionskin::mechanics
