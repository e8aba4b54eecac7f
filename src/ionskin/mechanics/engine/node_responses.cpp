// SPDX-License-Identifier: Apache-2.0
#include "ionskin/base/largest.hpp"
#include "ionskin/base/system/interrupt.hpp"
#include "ionskin/linear_algebra/dense_kernels.hpp"
#include "ionskin/mechanics/elasticity/core_strain.hpp"
#include "ionskin/mechanics/engine/load_patterns.hpp"
#include "ionskin/mechanics/engine/position_nodes.hpp"
#include "ionskin/parallel/task_pool.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace ionskin::mechanics {
namespace {

using linear_algebra::DenseMatrix;
using Response = CondensedPosition::Response;

/// Electrode stress and residual are those of nodes with at least this weight.
constexpr double counting_weight = 0.3;
/// Part of a state's load that its combination of others may lack: over the largest load, and over
/// the tolerance of the interpolation between the nodes.
constexpr double negligible_share = 0.02;
/// Patterns whose strains are held at a time.
constexpr std::size_t patterns_at_once = 48;
/// Points of the strain that are combined at a time: they stay in the cache of one core.
constexpr std::size_t points_at_once = 1024;

double norm(const CellVector& force) {
  double square = 0;
  for (const double component : force) {
    square += component * component;
  }
  return std::sqrt(square);
}

/// sums[state] += share(pattern, state) responses[pattern], of the strains. The shapes of the
/// products do not depend on the number of threads, and so neither do their bits.
/// @param share of those patterns
void add_strains(const std::vector<Response>& responses, const DenseMatrix& share,
                 const std::vector<std::size_t>& states, int threads, std::vector<Response>& sums) {
  const auto& components = responses.front().strain.component;
  const std::size_t points = components.front().size(),
                    blocks = (points + points_at_once - 1) / points_at_once;
  parallel::run_tasks(components.size() * blocks, threads, [&](std::size_t task) {
    const std::size_t c = task / blocks, begin = task % blocks * points_at_once,
                      count = std::min(points_at_once, points - begin);
    DenseMatrix of_patterns(static_cast<int>(count), share.rows),
        of_states(static_cast<int>(count), share.columns);
    for (int j = 0; j < share.rows; ++j) {
      std::copy_n(responses[static_cast<std::size_t>(j)].strain.component[c].data() + begin, count,
                  of_patterns.column(j));
    }
    linear_algebra::product(false, of_states.rows, of_states.columns, share.rows, 1,
                            of_patterns.values.data(), of_patterns.rows, share.values.data(),
                            share.rows, 0, of_states.values.data(), of_states.rows);
    for (int k = 0; k < share.columns; ++k) {
      double* to = sums[states[static_cast<std::size_t>(k)]].strain.component[c].data() + begin;
      const double* from = of_states.column(k);
      std::transform(from, from + count, to, to, std::plus<>());
    }
  });
}

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
/// company.
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

/// Loads of states at one node, and what came of them.
struct NodeLoads {
  std::array<bool, 2> reflect{};
  std::vector<std::size_t> states;
  std::vector<double> weight; ///< of the node in each state
  std::vector<CellVector> patterns;
  DenseMatrix share; ///< of the patterns in each state
  std::vector<std::vector<double>> electrode_strain{};
  double residual = 0;
};

DenseMatrix rows_of(const DenseMatrix& matrix, std::size_t first, std::size_t count) {
  DenseMatrix rows(static_cast<int>(count), matrix.columns);
  for (int j = 0; j < matrix.columns; ++j) {
    std::copy_n(matrix.column(j) + first, count, rows.column(j));
  }
  return rows;
}

/// Stress and residual of the states where the node counts.
void add_largest(const CondensedPosition& condensed, const NodeLoads& loads,
                 std::vector<Response>& sums) {
  for (std::size_t i = 0; i < loads.states.size(); ++i) {
    if (std::abs(loads.weight[i]) < counting_weight || loads.patterns.empty()) {
      continue;
    }
    std::vector<double> strain(loads.electrode_strain.front().size());
    for (std::size_t j = 0; j < loads.electrode_strain.size(); ++j) {
      const double share = loads.share(static_cast<int>(j), static_cast<int>(i)) / loads.weight[i];
      for (std::size_t k = 0; share != 0 && k < strain.size(); ++k) {
        strain[k] += share * loads.electrode_strain[j][k];
      }
    }
    const std::vector<double> stress = condensed.electrode_stress(strain);
    Response& sum = sums[loads.states[i]];
    sum.electrode_stress.resize(stress.size());
    std::ranges::transform(stress, sum.electrode_stress, sum.electrode_stress.begin(),
                           base::larger);
    sum.equilibrium_residual = base::larger(sum.equilibrium_residual, loads.residual);
  }
}

/// Nodes that mirror each other are one place, and so one product.
void add_place(const CondensedPosition& condensed, std::vector<NodeLoads>& nodes, int threads,
               std::vector<Response>& sums) {
  std::vector<std::pair<NodeLoads*, std::size_t>> open;
  for (NodeLoads& node : nodes) {
    for (std::size_t j = 0; j < node.patterns.size(); ++j) {
      open.emplace_back(&node, j);
    }
  }
  for (std::size_t first = 0; first < open.size(); first += patterns_at_once) {
    const std::size_t last = std::min(open.size(), first + patterns_at_once);
    std::vector<CellVector> loads;
    for (std::size_t i = first; i < last; ++i) {
      loads.push_back(open[i].first->patterns[open[i].second]);
    }
    std::vector<Response> responses = responses_of(condensed, loads, threads);
    for (std::size_t begin = first; begin < last;) {
      NodeLoads& node = *open[begin].first;
      std::vector<Response> own;
      std::size_t at = begin;
      for (; at < last && open[at].first == &node; ++at) {
        Response& response = own.emplace_back(std::move(responses[at - first]));
        if (node.reflect[0] || node.reflect[1]) {
          response.strain = mirrored(std::move(response.strain), node.reflect);
        }
        node.residual = base::larger(node.residual, response.equilibrium_residual);
        node.electrode_strain.push_back(std::move(response.electrode_strain));
      }
      add_strains(own, rows_of(node.share, open[begin].second, own.size()), node.states, threads,
                  sums);
      begin = at;
    }
  }
  for (const NodeLoads& node : nodes) {
    add_largest(condensed, node, sums);
  }
}

} // namespace

PositionNodes::Weights PositionNodes::weights_at(const std::array<double, 2>& place) const {
  Weights weights{node_weights(lines_, place), {}};
  weights.across = weights.along;
  if (options_.across_at_ends) {
    const std::vector<double>& line = lines_[lines_[0].size() > 1 ? 0 : 1];
    const double at = place[lines_[0].size() > 1 ? 0 : 1];
    std::ranges::fill(weights.across, 0.0);
    weights.across.back() =
        std::clamp((at - line.front()) / (line.back() - line.front()), 0.0, 1.0);
    weights.across.front() = 1 - weights.across.back();
  }
  return weights;
}

CellVector PositionNodes::weighted(const CellVector& force, double along, double across) const {
  const std::size_t direction = lines_[0].size() > 1 ? 2 : 1; // across the line
  CellVector result(force.size());
  for (std::size_t i = 0; i < force.size(); ++i) {
    result[i] = (i % 3 == direction ? across : along) * force[i];
  }
  return result;
}

std::vector<Response> PositionNodes::respond(const std::vector<std::array<double, 2>>& places,
                                             const std::vector<CellVector>& forces) const {
  std::vector<Response> sums(places.size(), Response{no_strain(model_->mesh), {}, 0, {}});
  std::vector<Weights> weights;
  double largest = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    weights.push_back(weights_at(places[i]));
    largest = std::max(largest, norm(forces[i]));
  }
  for (std::size_t place = 0; place < places_.size(); ++place) {
    base::check_interrupt();
    std::vector<NodeLoads> loads;
    bool any = false;
    for (std::size_t n = 0; n < nodes_.size(); ++n) {
      if (nodes_[n].condensed == place) {
        NodeLoads& node = loads.emplace_back(NodeLoads{nodes_[n].position.reflect, {}, {}, {}, {}});
        std::vector<CellVector> all;
        for (std::size_t i = 0; i < places.size(); ++i) {
          const double along = weights[i].along[n], across = weights[i].across[n];
          if (along != 0 || across != 0) { // places on nodes need no others
            node.states.push_back(i);
            node.weight.push_back(along);
            all.push_back(
                reflected(model_->cells, weighted(forces[i], along, across), node.reflect));
          }
        }
        if (!all.empty()) {
          LoadPatterns patterns = load_patterns(all, negligible_share * tolerance_ * largest);
          node.share = std::move(patterns.share);
          for (const std::size_t index : patterns.chosen) {
            node.patterns.push_back(std::move(all[index]));
          }
        }
        any = any || !node.patterns.empty();
      }
    }
    if (any) {
      add_place(*condensed_at(place), loads, options_.threads, sums);
    }
  }
  return sums;
}

} // namespace ionskin::mechanics
