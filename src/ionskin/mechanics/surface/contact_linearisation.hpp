// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/mechanics/surface/contact_problem.hpp"

#include <Eigen/Core>
#include <Eigen/LU>

#include <vector>

namespace ionskin::mechanics {

/// Values of an iteration.
struct Iterate {
  CellVector force;       ///< [N]
  double indentation = 0; ///< [m]
};

/// State of the cells of an iterate.
struct Standing {
  CellVector surface; ///< mean displacement of each cell [m]
  std::vector<laws::CellTrial> trial;
  std::vector<laws::CellResponse> response;
  std::vector<laws::CellStatus> status;
  std::vector<int> active;  ///< cells that touch or are pulled
  double residual = 0;      ///< largest, of the forces less those that are allowed [N]
  double largest_force = 0; ///< normal, of a cell [N]

  Standing(const ContactProblem& problem, const SliderStep& step, const Iterate& iterate);
};

/// The equations of the active cells, linearised where they stand. Unknowns are the changes of
/// their forces and, under a given force, of the indentation. Where the tangential force of a cell
/// follows from its normal force alone (without friction, in steady sliding, where it is pulled) it
/// is not an unknown.
class ContactLinearisation {
public:
  ContactLinearisation(const ContactProblem& problem, const SliderStep& step, const Standing& at);

  /// Number of the equations.
  Eigen::Index size() const { return size_; }
  Eigen::MatrixXd matrix() const;
  /// The matrix times changes of the unknowns.
  Eigen::VectorXd times(const Eigen::VectorXd& change) const;
  /// About the changes that make a right side, where the problem has products: touching cells by
  /// the inverse of their waves, as if what lies between them were open skin that does not move.
  Eigen::VectorXd about_inverse(const Eigen::VectorXd& right) const;
  /// One step of Newton's method. @param factor of the matrix, or of one like it
  void correct(const Eigen::PartialPivLU<Eigen::MatrixXd>& factor, Iterate& iterate) const;
  /// One step of Newton's method by GMRES, without a matrix.
  /// @param reduction of the residual of the linear equations
  void correct_by_products(double reduction, Iterate& iterate);

private:
  bool force_given() const { return step_.load.kind == LoadKind::force; }
  bool follows(int cell) const;
  /// Sets the forces that follow from the others. @returns the surface behind it [m]
  CellVector settle_followers(CellVector& force) const;
  Eigen::VectorXd residual(const Iterate& iterate, const CellVector& surface) const;
  /// Change of the equations of a cell by its displacement.
  /// @param i place among the active cells @param moved the cell: normal, x, y [m]
  void equations_by_surface(int i, const double* moved, double* row) const;
  double own_tangential(int cell, int r, int s) const;
  double by_indentation(int cell) const;
  Eigen::VectorXd pressed_by(const Eigen::VectorXd& displacement) const;
  void move(const Eigen::VectorXd& change, Iterate& iterate) const;
  /// Surface displacement by an unknown [m/N]. @param i place among the active cells
  void displacement_by(int i, int component, Eigen::VectorXd& result) const;

  const ContactProblem& problem_;
  const SliderStep& step_;
  const Standing& at_;
  std::vector<Eigen::Index> first_; ///< equation of each active cell
  bool sticks_ = false;             ///< a cell with tangential forces as unknowns
  Eigen::VectorXd by_one_;          ///< about the normal forces that an indentation of 1 makes [N]
  Eigen::Index size_ = 0;
};

} // namespace ionskin::mechanics
