// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/finite_layers/thickness/elastic_layer.hpp"

#include <Eigen/Core>

namespace ionskin::finite_layers {

/// A finite element through a part of the thickness: polynomials through Gauss-Lobatto nodes, with
/// the Gauss-Legendre points at which products of them are integrated exactly.
struct LobattoElement {
  /// Element of a degree of its polynomials, at least 1, and a size along the thickness [m].
  LobattoElement(int degree, double size);

  LobattoElement scaled_to(double size) const;

  Eigen::VectorXd nodes;  ///< from 0 to the size [m]
  Eigen::VectorXd points; ///< of quadrature [m]
  Eigen::VectorXd weights;
  Eigen::MatrixXd values; ///< of the shape functions at the points, [points, nodes]
  Eigen::MatrixXd slopes; ///< [1/m]

  Eigen::MatrixXd mass() const;       ///< integrals of N_i N_j [m]
  Eigen::MatrixXd stiffness() const;  ///< of N_i' N_j' [1/m]
  Eigen::MatrixXd convection() const; ///< of N_i N_j' [1]

  /// Shape functions and their slopes [1/m] at a place from 0 to the size [m], and their means.
  Eigen::RowVectorXd values_at(double place) const;
  Eigen::RowVectorXd slopes_at(double place) const;
  Eigen::RowVectorXd means() const;
  Eigen::RowVectorXd mean_slopes() const;

private:
  double size_;
  Eigen::MatrixXd to_legendre_; ///< coefficients of Legendre polynomials over values at the nodes
};

/// Energy matrix of the element in the unknowns (U_r at the nodes, w at the nodes) for waves of one
/// number, docs/model.md (49).
/// @param wave_number [1/m]
Eigen::MatrixXd plane_strain_matrix(const LobattoElement& element, const ElasticLayer& layer,
                                    double wave_number);

} // namespace ionskin::finite_layers
