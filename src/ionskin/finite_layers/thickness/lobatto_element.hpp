// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/finite_layers/thickness/elastic_layer.hpp"

#include <Eigen/Core>

namespace ionskin::finite_layers {

/// Finite element through a part of the thickness. Its shape functions N_i are polynomials through
/// Gauss-Lobatto nodes. Products of two of them are integrated exactly by Gauss-Legendre
/// quadrature.
struct LobattoElement {
  /// Makes an element.
  /// @param degree of the shape functions, at least 1
  /// @param size of the element along the thickness [m]
  LobattoElement(int degree, double size);

  /// Returns the element of the same degree with another size [m].
  LobattoElement scaled_to(double size) const;

  Eigen::VectorXd nodes;   ///< positions of the nodes, from 0 to the size [m]
  Eigen::VectorXd points;  ///< positions of the quadrature points [m]
  Eigen::VectorXd weights; ///< quadrature weights [m]
  Eigen::MatrixXd values;  ///< of the shape functions at the quadrature points, [point, node] [1]
  Eigen::MatrixXd slopes;  ///< derivatives of the shape functions there, [point, node] [1/m]

  Eigen::MatrixXd mass() const;       ///< integrals of N_i N_j [m]
  Eigen::MatrixXd stiffness() const;  ///< integrals of N_i' N_j' [1/m]
  Eigen::MatrixXd convection() const; ///< integrals of N_i N_j' [1]

  /// Evaluates the shape functions [1] at a position from 0 to the size [m].
  Eigen::RowVectorXd values_at(double place) const;
  /// Evaluates the derivatives of the shape functions [1/m] at a position from 0 to the size [m].
  Eigen::RowVectorXd slopes_at(double place) const;
  /// Calculates the means of the shape functions over the element [1].
  Eigen::RowVectorXd means() const;
  /// Calculates the means of the derivatives of the shape functions over the element [1/m].
  Eigen::RowVectorXd mean_slopes() const;

private:
  double size_;
  /// Maps values at the nodes to coefficients of Legendre polynomials.
  Eigen::MatrixXd to_legendre_;
};

/// Calculates the stiffness matrix of the element in plane strain, for displacements that vary
/// along the layer like a wave: the matrix of twice the energy per volume of docs/model.md (49),
/// integrated over the element [Pa/m]. The unknowns are U_r at all nodes, then w at all nodes.
/// @param wave_number [1/m]
Eigen::MatrixXd plane_strain_matrix(const LobattoElement& element, const ElasticLayer& layer,
                                    double wave_number);

} // namespace ionskin::finite_layers
