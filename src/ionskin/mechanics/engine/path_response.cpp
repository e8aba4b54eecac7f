// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/engine/path_response.hpp"

#include "ionskin/base/largest.hpp"
#include "ionskin/linear_algebra/dense_kernels.hpp"
#include "ionskin/mechanics/elasticity/core_strain.hpp"
#include "ionskin/parallel/task_pool.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ionskin::mechanics {
namespace {

using linear_algebra::DenseMatrix;
using Response = CondensedPosition::Response;

/// Electrode stress and residual are those of nodes with at least this weight.
constexpr double counting_weight = 0.3;
/// Patterns whose strains are held at a time.
constexpr int patterns_at_once = 48;
/// Points of the strain that are combined at a time: they stay in the cache of one core.
constexpr std::size_t points_at_once = 1024;

/// Loads of one position, their order kept. Without a factor every load is the same bits in any
/// company; with one, which shares its own work among threads, they are recovered together.
std::vector<Response> responses_of(const CondensedPosition& condensed,
                                   const std::vector<CellVector>& loads, int threads) {
  if (condensed.holds_factor()) {
    return condensed.respond(loads);
  }
  const auto parts = std::min(loads.size(), static_cast<std::size_t>(std::max(1, threads)));
  std::vector<Response> responses(loads.size());
  parallel::run_tasks(parts, threads, [&](std::size_t part) {
    const std::size_t begin = loads.size() * part / parts, end = loads.size() * (part + 1) / parts;
    auto own = condensed.respond({loads.begin() + static_cast<std::ptrdiff_t>(begin),
                                  loads.begin() + static_cast<std::ptrdiff_t>(end)});
    std::move(own.begin(), own.end(), responses.begin() + static_cast<std::ptrdiff_t>(begin));
  });
  return responses;
}

/// Of the states where the node counts.
void keep_stresses(const CondensedPosition& condensed,
                   const std::vector<std::vector<double>>& electrode_strain, NodeResponse& node) {
  for (std::size_t i = 0; i < node.states.size(); ++i) {
    if (std::abs(node.weight[i]) < counting_weight || electrode_strain.empty()) {
      continue;
    }
    std::vector<double> strain(electrode_strain.front().size());
    for (std::size_t j = 0; j < electrode_strain.size(); ++j) {
      const double share = node.share(static_cast<int>(j), static_cast<int>(i)) / node.weight[i];
      for (std::size_t k = 0; share != 0 && k < strain.size(); ++k) {
        strain[k] += share * electrode_strain[j][k];
      }
    }
    node.electrode_stress[i] = condensed.electrode_stress(strain);
  }
}

/// Under some of a node's patterns, as at the node.
std::vector<CoreStrain> pattern_strains(const NodeResponse& node,
                                        const std::array<std::size_t, 2>& core_z, int first,
                                        int count, int threads) {
  std::vector<CoreStrain> strains(static_cast<std::size_t>(count));
  parallel::run_tasks(strains.size(), threads, [&](std::size_t i) {
    const std::size_t pattern = static_cast<std::size_t>(first) + i;
    LatticeDisplacement lattice(node.core.rows());
    node.core.get(pattern, lattice.data());
    strains[i] = lattice_strain(node.lines, core_z, lattice.data());
    if (node.reflect[0] || node.reflect[1]) {
      strains[i] = mirrored(std::move(strains[i]), node.reflect);
    }
  });
  return strains;
}

/// sums[state] += share(pattern, state) strain(pattern). The shapes of the products do not depend
/// on the number of threads, and so neither do their bits.
/// @param share [patterns, states]
/// @param sums of each state
void add_strains(const std::vector<CoreStrain>& strains, const DenseMatrix& share, int threads,
                 const std::vector<CoreStrain*>& sums) {
  const std::size_t components = strains.front().component.size(),
                    points = strains.front().component.front().size(),
                    blocks = (points + points_at_once - 1) / points_at_once;
  parallel::run_tasks(components * blocks, threads, [&](std::size_t task) {
    const std::size_t c = task / blocks, at = task % blocks * points_at_once,
                      count = std::min(points_at_once, points - at);
    DenseMatrix of_patterns(static_cast<int>(count), share.rows),
        of_states(static_cast<int>(count), share.columns);
    for (int j = 0; j < share.rows; ++j) {
      std::copy_n(strains[static_cast<std::size_t>(j)].component[c].data() + at, count,
                  of_patterns.column(j));
    }
    linear_algebra::product(false, of_states.rows, of_states.columns, share.rows, 1,
                            of_patterns.values.data(), of_patterns.rows, share.values.data(),
                            share.rows, 0, of_states.values.data(), of_states.rows);
    for (int k = 0; k < share.columns; ++k) {
      double* to = sums[static_cast<std::size_t>(k)]->component[c].data() + at;
      const double* from = of_states.column(k);
      std::transform(from, from + count, to, to, std::plus<>());
    }
  });
}

/// Rows and columns of a matrix from some on.
DenseMatrix block_of(const DenseMatrix& matrix, int row, int rows, int column, int columns) {
  DenseMatrix block(rows, columns);
  for (int k = 0; k < columns; ++k) {
    std::copy_n(matrix.column(column + k) + row, rows, block.column(k));
  }
  return block;
}

} // namespace

std::size_t PathResponse::bytes() const {
  std::size_t values = 0;
  for (const NodeResponse& node : nodes_) {
    values += static_cast<std::size_t>(node.share.rows) * lattice_rows(node.lines, core_z_);
  }
  return values * linear_algebra::FixedPointColumns::bytes_per_entry;
}

bool PathResponse::needs(std::size_t place) const {
  return std::ranges::any_of(nodes_, [place](const NodeResponse& node) {
    return node.place == place && !node.patterns.empty();
  });
}

// Nodes that mirror each other are one place, and so one product.
void PathResponse::solve(std::size_t place, const CondensedPosition& condensed, int threads) {
  struct Open {
    NodeResponse* node;
    std::size_t pattern;
  };
  std::vector<Open> open;
  for (NodeResponse& node : nodes_) {
    if (node.place == place) {
      node.core = {lattice_rows(node.lines, core_z_), node.patterns.size()};
      for (std::size_t j = 0; j < node.core.columns(); ++j) {
        open.push_back({&node, j});
      }
    }
  }
  std::vector<double> residuals;
  std::vector<std::vector<double>> strains_of_electrodes;
  for (std::size_t first = 0; first < open.size(); first += patterns_at_once) {
    const std::size_t last = std::min(open.size(), first + patterns_at_once);
    std::vector<CellVector> loads;
    for (std::size_t i = first; i < last; ++i) {
      loads.push_back(open[i].node->patterns[open[i].pattern]);
    }
    std::vector<Response> responses = responses_of(condensed, loads, threads);
    for (std::size_t i = first; i < last; ++i) {
      Response& response = responses[i - first];
      open[i].node->core.set(open[i].pattern, response.core.data());
      residuals.push_back(response.equilibrium_residual);
      strains_of_electrodes.push_back(std::move(response.electrode_strain));
    }
  }
  for (std::size_t begin = 0; begin < open.size();) {
    NodeResponse& node = *open[begin].node;
    const std::size_t end = begin + node.patterns.size();
    for (std::size_t i = begin; i < end; ++i) {
      node.residual = base::larger(node.residual, residuals[i]);
    }
    keep_stresses(condensed,
                  {strains_of_electrodes.begin() + static_cast<std::ptrdiff_t>(begin),
                   strains_of_electrodes.begin() + static_cast<std::ptrdiff_t>(end)},
                  node);
    node.patterns = {};
    begin = end;
  }
}

std::vector<StateResponse> PathResponse::states(std::size_t first, std::size_t count,
                                                int threads) const {
  CoreStrain none;
  const mesh::MeshLines& lines = nodes_.front().lines;
  none.points = {2 * (lines.x.size() - 1), 2 * (lines.y.size() - 1), 2 * (core_z_[1] - core_z_[0])};
  none.component.fill(std::vector<double>(none.points[0] * none.points[1] * none.points[2]));
  std::vector<StateResponse> sums(count, StateResponse{none, {}, 0});
  for (const NodeResponse& node : nodes_) {
    const auto at = [&](std::size_t state) {
      return static_cast<std::size_t>(std::ranges::lower_bound(node.states, state) -
                                      node.states.begin());
    };
    const std::size_t begin = at(first), end = at(first + count);
    if (begin == end) {
      continue;
    }
    std::vector<CoreStrain*> strains;
    for (std::size_t i = begin; i < end; ++i) {
      StateResponse& sum = sums[node.states[i] - first];
      strains.push_back(&sum.strain);
      const std::vector<double>& stress = node.electrode_stress[i];
      if (!stress.empty()) {
        sum.electrode_stress.resize(stress.size());
        std::ranges::transform(stress, sum.electrode_stress, sum.electrode_stress.begin(),
                               base::larger);
        sum.equilibrium_residual = base::larger(sum.equilibrium_residual, node.residual);
      }
    }
    for (int pattern = 0; pattern < node.share.rows; pattern += patterns_at_once) {
      const int patterns = std::min(patterns_at_once, node.share.rows - pattern);
      add_strains(pattern_strains(node, core_z_, pattern, patterns, threads),
                  block_of(node.share, pattern, patterns, static_cast<int>(begin),
                           static_cast<int>(end - begin)),
                  threads, strains);
    }
  }
  return sums;
}

} // namespace ionskin::mechanics
