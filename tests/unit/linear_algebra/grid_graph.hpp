// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/linear_algebra/sparse_matrix.hpp"

namespace ionskin::linear_algebra {

/// Seven-point graph of an n x n x n grid, lower triangle.
inline SymmetricPattern grid_graph(int n) {
  SymmetricPattern graph{n * n * n, {0}, {}};
  for (int k = 0; k < n; ++k) {
    for (int j = 0; j < n; ++j) {
      for (int i = 0; i < n; ++i) {
        const int node = i + n * (j + n * k);
        graph.row.push_back(node);
        if (i + 1 < n) {
          graph.row.push_back(node + 1);
        }
        if (j + 1 < n) {
          graph.row.push_back(node + n);
        }
        if (k + 1 < n) {
          graph.row.push_back(node + n * n);
        }
        graph.column_start.push_back(static_cast<int>(graph.row.size()));
      }
    }
  }
  return graph;
}

} // namespace ionskin::linear_algebra
