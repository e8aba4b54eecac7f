// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/mechanics/surface/contact_problem.hpp"

#include <Eigen/LU>

#include <array>
#include <vector>

namespace ionskin::mechanics {

/// What a contact cell does in one state; pulled is open, but held by adhesion.
enum class CellStatus { separated, sticking, slipping, pulled };

/// Where one cell stands: the forces that contact and friction would allow in its present motion.
struct CellPredictor {
  CellStatus status = CellStatus::separated;
  std::array<double, 2> tangential{}; ///< trial force t + slip / compliance [N]
  double residual = 0;                ///< of the projection equations [N]
};

/// Where an iteration stands.
struct Iterate {
  CellVector force;       ///< [N]
  double indentation = 0; ///< [m]
};

/// @param surface displacement under the iterate's forces [m]
CellPredictor predict(const ContactProblem& problem, const SliderStep& step, const Iterate& iterate,
                      const CellVector& surface, int cell);

/// The linearised equations of the cells that touch or are pulled; unknowns are their forces and,
/// under a given force, the indentation at the end.
class LinearSystem {
public:
  LinearSystem(const ContactProblem& problem, const SliderStep& step,
               const std::vector<int>& touching);

  /// Of all its cells, linearised about an iterate. @param predictors [all cells]
  void add_rows(const std::vector<CellPredictor>& predictors, const Iterate& iterate);
  /// Puts the solution in the iterate's place.
  void solve(Iterate& iterate) const;
  const Eigen::MatrixXd& matrix() const { return matrix_; }

private:
  int count() const { return static_cast<int>(touching_.size()); }
  bool force_given() const { return step_.load.kind == LoadKind::force; }
  int size() const { return 3 * count() + (force_given() ? 1 : 0); }
  /// That the forces add up to the load, where it is given.
  void add_load_row();
  /// @param i place of the cell among those that touch or are pulled
  void add_normal_row(int i);
  void add_pulled_rows(int i);
  void add_stick_rows(int i);
  /// The force that friction allows, linearised about the trial force and a normal force.
  void add_slip_rows(int i, const CellPredictor& predictor, double normal_force);
  /// Adds scale times the opening of a cell to its normal row.
  void add_opening(int i, double scale);
  /// Adds scale times the displacement of a component to a row.
  void add_displacement(int row, int component, double scale);
  /// Displacement at which a cell does not slip.
  double free_displacement(int cell, int c) const;

  const ContactProblem& problem_;
  const SliderStep& step_;
  const std::vector<int>& touching_;
  Eigen::MatrixXd matrix_;
  Eigen::VectorXd right_;
};

/// Whether the determinant of a factorised matrix is positive: of a contact with adhesion, that its
/// equilibrium can last. Where the pull falls with the opening faster than the skin springs back,
/// the sign has changed, docs/model.md (43).
bool has_positive_determinant(const Eigen::PartialPivLU<Eigen::MatrixXd>& factor);

} // namespace ionskin::mechanics
