// SPDX-License-Identifier: Apache-2.0
#include "ionskin/linear_algebra/fill_ordering.hpp"

#include "ionskin/base/system/blocked_signal.hpp"
#include "ionskin/linear_algebra/cholmod_handles.hpp"

#include <algorithm>
#include <csignal>
#include <mutex>
#include <new>
#include <utility>

namespace ionskin::linear_algebra {
namespace {

/// The graph with its nodes renumbered: node i becomes number[i]; negative numbers drop the node.
SymmetricPattern renumbered(const SymmetricPattern& graph, const std::vector<int>& number,
                            int size) {
  std::vector<std::vector<int>> columns(static_cast<std::size_t>(size));
  for (int j = 0; j < graph.size; ++j) {
    for (int p = graph.column_start[j]; p < graph.column_start[j + 1]; ++p) {
      const int a = number[graph.row[p]], b = number[j];
      if (a >= 0 && b >= 0) {
        columns[std::min(a, b)].push_back(std::max(a, b));
      }
    }
  }
  SymmetricPattern result{size, {0}, {}};
  for (auto& column : columns) {
    std::sort(column.begin(), column.end());
    result.row.insert(result.row.end(), column.begin(), column.end());
    result.column_start.push_back(static_cast<int>(result.row.size()));
  }
  return result;
}

/// Reorders `order` so that the leading nodes stand in postorder of the elimination tree of the
/// whole graph, whose trailing nodes form its stem.
void postorder_leading(const SymmetricPattern& graph, std::vector<int>& order, int leading,
                       CholmodWorkspace& workspace) {
  std::vector<int> number(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    number[order[k]] = static_cast<int>(k);
  }
  const SymmetricPattern ordered = renumbered(graph, number, graph.size);
  cholmod_sparse lower = view(ordered, nullptr);
  cholmod_sparse* upper = cholmod_transpose(&lower, 0, *workspace); // cholmod_etree wants it
  workspace.check("transpose");
  std::vector<int> parent(order.size()), post(order.size());
  cholmod_etree(upper, parent.data(), *workspace);
  cholmod_free_sparse(&upper, *workspace);
  workspace.check("etree");
  const int size = graph.size;
  for (int k = 0; k < size; ++k) {
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
  order = std::move(result);
}

/// Whether every number below its length stands in it once.
bool is_permutation(const std::vector<int>& numbers) {
  std::vector<bool> found(numbers.size());
  for (const int k : numbers) {
    if (k < 0 || static_cast<std::size_t>(k) >= found.size() || found[k]) {
      return false;
    }
    found[k] = true;
  }
  return true;
}

/// METIS takes SIGTERM for itself meanwhile, for the whole process, and would leave its work and
/// the order undone. Two at a time would each put back the other's handler. METIS gives up where
/// memory runs out, and CHOLMOD does not ask whether it did: the order is then what was there.
void nested_dissection(cholmod_sparse& matrix, std::vector<int>& permutation,
                       CholmodWorkspace& workspace) {
  static std::mutex one_at_a_time;
  const base::BlockedSignal later(SIGTERM);
  const std::lock_guard lock(one_at_a_time);
  struct sigaction ours {};
  sigaction(SIGTERM, nullptr, &ours);
  cholmod_metis(&matrix, nullptr, 0, 0, permutation.data(), *workspace);
  sigaction(SIGTERM, &ours, nullptr); // METIS puts it back for one signal only
  workspace.check("nested dissection");
  if (!is_permutation(permutation)) {
    throw std::bad_alloc();
  }
}

} // namespace

std::vector<int> trailing_ordering(const SymmetricPattern& graph,
                                   const std::vector<int>& trailing) {
  std::vector<int> number(static_cast<std::size_t>(graph.size), 0);
  for (const int node : trailing) {
    number[node] = -1;
  }
  std::vector<int> leading;
  for (int node = 0; node < graph.size; ++node) {
    if (number[node] == 0) {
      number[node] = static_cast<int>(leading.size());
      leading.push_back(node);
    }
  }
  CholmodWorkspace workspace;
  std::vector<int> order;
  if (!leading.empty()) {
    const SymmetricPattern rest = renumbered(graph, number, static_cast<int>(leading.size()));
    cholmod_sparse matrix = view(rest, nullptr);
    std::vector<int> permutation(leading.size());
    nested_dissection(matrix, permutation, workspace);
    for (const int k : permutation) {
      order.push_back(leading[k]);
    }
  }
  order.insert(order.end(), trailing.begin(), trailing.end());
  postorder_leading(graph, order, static_cast<int>(leading.size()), workspace);
  return order;
}

} // namespace ionskin::linear_algebra
