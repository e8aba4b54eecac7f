// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include <functional>

namespace ionskin::mechanics {

using LinearMap = std::function<Eigen::VectorXd(const Eigen::VectorXd&)>;

/// Solves product(x) = right by generalised minimal residuals (Saad and Schultz 1986, doi
/// 10.1137/0907058), preconditioned from the right and restarted to limit memory, until the
/// residual has fallen by a given factor or no longer falls.
/// @param product linear map of the equations
/// @param about_inverse preconditioner: approximate inverse of `product`, the same linear map in
///   each call
/// @param right right side of the equations
/// @param reduction residual to reach, over that of x = 0 [1]
/// @returns x
Eigen::VectorXd gmres(const LinearMap& product, const LinearMap& about_inverse,
                      const Eigen::VectorXd& right, double reduction);

} // namespace ionskin::mechanics
