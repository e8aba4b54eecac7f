// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include <vector>

namespace ionskin::live {

/// Appends the entries of a matrix to a list, row by row, in single precision.
inline void append(std::vector<float>& values, const Eigen::MatrixXd& rows) {
  for (Eigen::Index i = 0; i < rows.rows(); ++i) {
    for (Eigen::Index j = 0; j < rows.cols(); ++j) {
      values.push_back(static_cast<float>(rows(i, j)));
    }
  }
}

} // namespace ionskin::live
