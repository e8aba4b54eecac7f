// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/linear_algebra/sparse_matrix.hpp"

#include <vector>

namespace ionskin::linear_algebra {

/// Fill-reducing elimination order of the nodes of a graph with `trailing` last, in the order
/// given. The others are ordered by METIS nested dissection (Karypis and Kumar 1998,
/// doi 10.1137/S1064827595287997) and postordered.
/// @param graph symmetric pattern of the node graph
/// @return order[k] is the k-th node to eliminate
std::vector<int> trailing_ordering(const SymmetricPattern& graph, const std::vector<int>& trailing);

} // namespace ionskin::linear_algebra
