// SPDX-License-Identifier: Apache-2.0
#include "ionskin/linear_algebra/postorder.hpp"

#include "ionskin/linear_algebra/cholmod_handles.hpp"
#include "ionskin/linear_algebra/renumbered_pattern.hpp"

namespace ionskin::linear_algebra {
std::vector<int> postordered(const SymmetricPattern& graph, const std::vector<int>& order,
                             int trailing) {
  const SymmetricPattern ordered = renumbered(graph, order).pattern;
  CholmodWorkspace workspace;
  cholmod_sparse lower = view(ordered, nullptr);
  cholmod_sparse* upper = cholmod_transpose(&lower, 0, *workspace); // cholmod_etree wants it
  workspace.check("transpose");
  std::vector<int> parent(order.size()), post(order.size());
  cholmod_etree(upper, parent.data(), *workspace);
  cholmod_free_sparse(&upper, *workspace);
  workspace.check("etree");
  const int size = graph.size, leading = size - trailing;
  for (int k = 0; k < size; ++k) { // the trailing nodes are the stem of the tree
    if (k < leading && parent[k] >= leading) {
      parent[k] = leading;
    } else if (k >= leading) {
      parent[k] = k + 1 < size ? k + 1 : -1;
    }
  }
  cholmod_postorder(parent.data(), order.size(), nullptr, post.data(), *workspace);
  workspace.check("postorder");
  std::vector<int> result(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    result[k] = order[post[k]];
  }
  return result;
}

} // namespace ionskin::linear_algebra
