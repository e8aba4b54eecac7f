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
/// Patterns whose strains are held at a time as they are recovered.
constexpr std::size_t patterns_at_once = 48;
/// Points of the strain that are combined at a time: they stay in the cache of one core.
constexpr std::size_t points_at_once = 1024;

CoreStrain no_strain(const mesh::SkinMesh& mesh) {
  const auto [nx, ny, nz] = mesh.elements();
  const auto [bottom, top] = mesh.core_z();
  CoreStrain strain;
  strain.points = {2 * nx, 2 * ny, 2 * (top - bottom)};
  for (auto& component : strain.component) {
    component.resize(strain.points[0] * strain.points[1] * strain.points[2]);
  }
  return strain;
}

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

void keep_strain(const CoreStrain& strain, int column, linear_algebra::FixedPointMatrix& kept) {
  std::vector<double> whole;
  whole.reserve(static_cast<std::size_t>(kept.rows));
  for (const auto& component : strain.component) {
    whole.insert(whole.end(), component.begin(), component.end());
  }
  kept.set_column(column, whole.data());
}

/// Of the states where the node counts.
void keep_stresses(const CondensedPosition& condensed,
                   const std::vector<std::vector<double>>& electrode_strain, NodeResponse& node) {
  node.electrode_stress.resize(node.states.size());
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

/// sums[state - first] += share(pattern, state) strain(pattern), of the node's states from `begin`
/// to `end`. The shapes of the products do not depend on the number of threads, and so neither do
/// their bits.
void add_strains(const NodeResponse& node, std::size_t begin, std::size_t end, std::size_t first,
                 int threads, std::vector<Response>& sums) {
  const int patterns = node.share.rows;
  DenseMatrix share(patterns, static_cast<int>(end - begin));
  for (int k = 0; k < share.columns; ++k) {
    std::copy_n(node.share.column(static_cast<int>(begin) + k), patterns, share.column(k));
  }
  const std::size_t components = sums.front().strain.component.size(),
                    points = sums.front().strain.component.front().size(),
                    blocks = (points + points_at_once - 1) / points_at_once;
  parallel::run_tasks(components * blocks, threads, [&](std::size_t task) {
    const std::size_t c = task / blocks, at = task % blocks * points_at_once,
                      count = std::min(points_at_once, points - at);
    DenseMatrix of_patterns(static_cast<int>(count), patterns),
        of_states(static_cast<int>(count), share.columns);
    for (int j = 0; j < patterns; ++j) {
      const std::int32_t* from =
          node.strain.values.data() +
          static_cast<std::size_t>(node.strain.rows) * static_cast<std::size_t>(j) + c * points +
          at;
      std::transform(from, from + count, of_patterns.column(j),
                     [unit = node.strain.unit[j]](std::int32_t value) { return unit * value; });
    }
    linear_algebra::product(false, of_states.rows, of_states.columns, patterns, 1,
                            of_patterns.values.data(), of_patterns.rows, share.values.data(),
                            share.rows, 0, of_states.values.data(), of_states.rows);
    for (int k = 0; k < share.columns; ++k) {
      double* to = sums[node.states[begin + static_cast<std::size_t>(k)] - first]
                       .strain.component[c]
                       .data() +
                   at;
      const double* from = of_states.column(k);
      std::transform(from, from + count, to, to, std::plus<>());
    }
  });
}

} // namespace

PathResponse::PathResponse(const mesh::SkinMesh& mesh, std::size_t states,
                           std::vector<NodeResponse> nodes)
    : none_(no_strain(mesh)), states_(states), nodes_(std::move(nodes)) {}

std::size_t PathResponse::bytes() const {
  std::size_t patterns = 0;
  for (const NodeResponse& node : nodes_) {
    patterns += static_cast<std::size_t>(node.share.rows);
  }
  return patterns * none_.component.size() * none_.component.front().size() * sizeof(std::int32_t);
}

bool PathResponse::needs(std::size_t place) const {
  return std::ranges::any_of(nodes_, [place](const NodeResponse& node) {
    return node.place == place && !node.patterns.empty();
  });
}

// Nodes that mirror each other are one place, and so one product.
void PathResponse::solve(std::size_t place, const CondensedPosition& condensed, int threads) {
  const auto rows = static_cast<int>(none_.component.size() * none_.component.front().size());
  struct Open {
    NodeResponse* node;
    int pattern;
  };
  std::vector<Open> open;
  for (NodeResponse& node : nodes_) {
    if (node.place == place) {
      node.strain = {rows, static_cast<int>(node.patterns.size())};
      for (int j = 0; j < node.strain.columns; ++j) {
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
      loads.push_back(open[i].node->patterns[static_cast<std::size_t>(open[i].pattern)]);
    }
    std::vector<Response> responses = responses_of(condensed, loads, threads);
    parallel::run_tasks(responses.size(), condensed.holds_factor() ? 1 : threads,
                        [&](std::size_t i) {
                          const auto [node, pattern] = open[first + i];
                          CoreStrain& strain = responses[i].strain;
                          if (node->reflect[0] || node->reflect[1]) {
                            strain = mirrored(std::move(strain), node->reflect);
                          }
                          keep_strain(strain, pattern, node->strain);
                        });
    for (Response& response : responses) {
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

std::vector<Response> PathResponse::states(std::size_t first, std::size_t count,
                                           int threads) const {
  std::vector<Response> sums(count, Response{none_, {}, 0, {}});
  for (const NodeResponse& node : nodes_) {
    const auto at = [&](std::size_t state) {
      return static_cast<std::size_t>(std::ranges::lower_bound(node.states, state) -
                                      node.states.begin());
    };
    const std::size_t begin = at(first), end = at(first + count);
    if (begin == end || node.share.rows == 0) {
      continue;
    }
    add_strains(node, begin, end, first, threads, sums);
    for (std::size_t i = begin; i < end; ++i) {
      const std::vector<double>& stress = node.electrode_stress[i];
      if (!stress.empty()) {
        Response& sum = sums[node.states[i] - first];
        sum.electrode_stress.resize(stress.size());
        std::ranges::transform(stress, sum.electrode_stress, sum.electrode_stress.begin(),
                               base::larger);
        sum.equilibrium_residual = base::larger(sum.equilibrium_residual, node.residual);
      }
    }
  }
  return sums;
}

} // namespace ionskin::mechanics
