// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/linear_algebra/sparse_matrix.hpp"

#include <vector>

namespace ionskin::linear_algebra {

/// An elimination order of the same fill whose nodes, but for the trailing ones, stand in postorder
/// of the elimination tree, so that those of equal columns follow one another.
/// @param graph symmetric pattern of the node graph
/// @param order order[k] is the k-th node to eliminate
/// @param trailing how many nodes at its end keep their places
std::vector<int> postordered(const SymmetricPattern& graph, const std::vector<int>& order,
                             int trailing);

} // namespace ionskin::linear_algebra
