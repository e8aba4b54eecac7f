// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include <functional>

namespace ionskin::mechanics {

using LinearMap = std::function<Eigen::VectorXd(const Eigen::VectorXd&)>;

/// Solves product(x) = right by generalised minimal residuals (Saad and Schultz 1986,
/// doi 10.1137/0907058), preconditioned from the right and begun anew after so many directions that
/// they fit into memory, until the residual has fallen by a factor or no longer falls.
/// @param about_inverse about the inverse of the product, the same linear map each time
/// @param reduction of the residual that is asked for
Eigen::VectorXd gmres(const LinearMap& product, const LinearMap& about_inverse,
                      const Eigen::VectorXd& right, double reduction);

} // namespace ionskin::mechanics
