// SPDX-License-Identifier: Apache-2.0
#include "ionskin/base/system/interrupt.hpp"
#include "ionskin/mechanics/engine/load_patterns.hpp"
#include "ionskin/mechanics/engine/position_nodes.hpp"
#include "ionskin/parallel/task_pool.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace ionskin::mechanics {
namespace {

/// Part of a state's load that its combination of others may lack: over the largest load, and over
/// the tolerance of the interpolation between the nodes.
constexpr double negligible_share = 0.02;

double norm(const CellVector& force) {
  double square = 0;
  for (const double component : force) {
    square += component * component;
  }
  return std::sqrt(square);
}

} // namespace

PositionNodes::Weights PositionNodes::weights_at(const std::array<double, 2>& place) const {
  Weights weights{node_weights(lines_, place), {}};
  weights.across = weights.along;
  if (options_.across_at_ends) {
    const std::vector<double>& line = lines_.at[lines_.at[0].size() > 1 ? 0 : 1];
    const double at = place[lines_.at[0].size() > 1 ? 0 : 1];
    std::ranges::fill(weights.across, 0.0);
    weights.across.back() =
        std::clamp((at - line.front()) / (line.back() - line.front()), 0.0, 1.0);
    weights.across.front() = 1 - weights.across.back();
  }
  return weights;
}

CellVector PositionNodes::weighted(const CellVector& force, double along, double across) const {
  const std::size_t direction = lines_.at[0].size() > 1 ? 2 : 1; // across the line
  CellVector result(force.size());
  for (std::size_t i = 0; i < force.size(); ++i) {
    result[i] = (i % 3 == direction ? across : along) * force[i];
  }
  return result;
}

PathResponse PositionNodes::patterns(std::span<const std::array<double, 2>> places,
                                     std::span<const CellVector> forces) const {
  std::vector<Weights> weights;
  double largest = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    weights.push_back(weights_at(places[i]));
    largest = std::max(largest, norm(forces[i]));
  }
  std::vector<NodeResponse> responses;
  for (std::size_t place = 0; place < places_.size(); ++place) {
    for (std::size_t n = 0; n < nodes_.size(); ++n) {
      if (nodes_[n].condensed != place) {
        continue;
      }
      NodeResponse& node =
          responses.emplace_back(NodeResponse{place,
                                              nodes_[n].position.reflect,
                                              model_->mesh.lines(places_[place].centre),
                                              {},
                                              {},
                                              {},
                                              {}});
      std::vector<CellVector> all;
      for (std::size_t i = 0; i < places.size(); ++i) {
        const double along = weights[i].along[n], across = weights[i].across[n];
        if (along != 0 || across != 0) { // places on nodes need no others
          node.states.push_back(i);
          node.weight.push_back(along);
          all.push_back(reflected(model_->cells, weighted(forces[i], along, across), node.reflect));
        }
      }
      if (!all.empty()) {
        LoadPatterns patterns = load_patterns(all, negligible_share * tolerance_ * largest);
        node.share = std::move(patterns.share);
        for (const std::size_t index : patterns.chosen) {
          node.patterns.push_back(std::move(all[index]));
        }
      }
    }
  }
  return {model_->mesh.core_z(), places.size(), std::move(responses)};
}

void PositionNodes::solve(const std::vector<PathResponse*>& paths,
                          const std::function<void()>& finished) const {
  // Those that share the part under the slider follow one another.
  const std::size_t along = model_->mesh.main_axis();
  std::vector<std::size_t> order(places_.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return places_[i].centre[1 - along]; });
  // A kept position shares its products among the threads, a factor is made by one of them as a
  // rule.
  parallel::SpareThreads spare;
  parallel::run_tasks(
      order.size(), holds_factors() ? options_.threads : 1,
      [&](std::size_t i) {
        base::check_interrupt();
        const auto needs = [&](const PathResponse* path) { return path->needs(order[i]); };
        if (std::ranges::any_of(paths, needs)) {
          const Condensed condensed = condensed_at(order[i], spare);
          for (PathResponse* path : paths) {
            path->solve(order[i], *condensed, options_.threads);
          }
        }
        finished();
      },
      &spare);
}

std::vector<StateResponse> PositionNodes::respond(const std::vector<std::array<double, 2>>& places,
                                                  const std::vector<CellVector>& forces) const {
  PathResponse path = patterns(places, forces);
  solve({&path});
  return path.states(0, path.count(), options_.threads);
}

} // namespace ionskin::mechanics
