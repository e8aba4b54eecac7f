// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/mechanics/surface/contact_problem.hpp"

#include <Eigen/Core>
#include <Eigen/LU>

#include <vector>

namespace ionskin::mechanics {

/// Iterate of Newton's method for a contact step.
struct Iterate {
  CellVector force;       ///< on the cells [N]
  double indentation = 0; ///< of the slider [m]
};

/// Evaluation of the contact equations at an iterate: displacement, trial forces, response and
/// status of each cell, and the residual.
struct ContactEvaluation {
  CellVector surface; ///< mean displacement of each cell [m]
  std::vector<laws::CellTrial> trial;
  std::vector<laws::CellResponse> response;
  std::vector<laws::CellStatus> status;
  std::vector<int> active; ///< active set: cells that touch or are pulled
  double residual = 0;     ///< largest difference of a force from what its law allows [N]
  /// Largest normal force or largest pull of a cell, as a magnitude [N]. At the height at which
  /// slider and undeformed skin meet, pull and pressure of an adhesive contact cancel.
  double largest_force = 0;

  ContactEvaluation(const ContactProblem& problem, const SliderStep& step, const Iterate& iterate);
};

/// Linearised equations of the active set at an iterate. Unknowns are the changes of the forces of
/// active cells [N] and, under a given force, the change of the indentation [m]. The tangential
/// forces of a cell are no unknowns where they follow from its normal force: without friction, in
/// steady sliding, and where the cell is pulled.
class ContactLinearisation {
public:
  /// Sets up the equations. All arguments must outlive this object.
  ContactLinearisation(const ContactProblem& problem, const SliderStep& step,
                       const ContactEvaluation& at);

  /// Number of the equations.
  Eigen::Index size() const { return size_; }
  /// Jacobian of the equations, [size, size]. Needs a problem that has its compliance as a matrix.
  Eigen::MatrixXd matrix() const;
  /// Product of the Jacobian with changes of the unknowns, without a matrix.
  Eigen::VectorXd times(const Eigen::VectorXd& change) const;
  /// Preconditioner: approximate changes of the unknowns for a right side, where the problem has
  /// its compliance as products. Touching cells take the inverse of the compliance wave by wave, as
  /// if all other cells were not displaced.
  Eigen::VectorXd about_inverse(const Eigen::VectorXd& right) const;
  /// Takes one step of Newton's method.
  /// @param factor factorised Jacobian of these equations, or of similar ones
  /// @param iterate changed in place
  void correct(const Eigen::PartialPivLU<Eigen::MatrixXd>& factor, Iterate& iterate) const;
  /// Takes one step of Newton's method, with linear equations solved by GMRES without a matrix.
  /// @param reduction factor by which the residual of the linear equations has to fall [1]
  /// @param iterate changed in place
  void correct_by_products(double reduction, Iterate& iterate);

private:
  bool force_given() const { return step_.load.kind == LoadKind::force; }
  /// True if the tangential forces of a cell follow from its normal force, and are no unknowns.
  bool follows(int cell) const;
  /// Overwrites the forces that are no unknowns: 0 on open cells, and tangential forces that follow
  /// from normal forces.
  /// @param force on all cells [N], changed in place
  /// @returns displacement of all cells under these forces [m]
  CellVector settle_followers(CellVector& force) const;
  /// Residual of each equation at an iterate [N], with forces that are no unknowns settled.
  /// @param surface displacement of the cells under the iterate's forces [m]
  Eigen::VectorXd residual(const Iterate& iterate, const CellVector& surface) const;
  /// Change of the equations of an active cell under a displacement of that cell.
  /// @param i index in the active set
  /// @param moved displacement of the cell: normal, x, y [m]
  /// @param row receives one value, or three where tangential forces are unknowns [N]
  void equations_by_surface(int i, const double* moved, double* row) const;
  /// Entry of the Jacobian: derivative of a cell's tangential equation r by its own tangential
  /// force s, at constant displacement [1].
  double own_tangential(int cell, int r, int s) const;
  /// Entry of the Jacobian: derivative of a cell's normal equation by the indentation [N/m].
  double by_indentation(int cell) const;
  /// Approximate normal forces of the active cells [N] that make normal displacements of the active
  /// cells [m].
  Eigen::VectorXd pressed_by(const Eigen::VectorXd& displacement) const;
  /// Subtracts changes of the unknowns from an iterate.
  void move(const Eigen::VectorXd& change, Iterate& iterate) const;
  /// Displacement of all cells by a unit force on an active cell, with the tangential force that
  /// follows from it [m/N].
  /// @param i index in the active set
  /// @param component of the force: 0 normal, 1 along x, 2 along y
  /// @param result receives the displacement, [3 cells]
  void displacement_by(int i, int component, Eigen::VectorXd& result) const;

  const ContactProblem& problem_;
  const SliderStep& step_;
  const ContactEvaluation& at_;
  std::vector<Eigen::Index> first_; ///< index of the first equation of each active cell
  bool sticks_ = false;             ///< true if a cell sticks whose tangential forces are unknowns
  /// Approximate normal forces of the active cells that an indentation of 1 m makes [N].
  Eigen::VectorXd by_one_;
  Eigen::Index size_ = 0; ///< number of equations
};

} // namespace ionskin::mechanics
