// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/sweep/sweep_batches.hpp"

#include "ionskin/electrochemistry/time/problem_size.hpp"
#include "ionskin/planning/cost_estimate.hpp"
#include "ionskin/study/sweep/sweep_mechanics.hpp"

#include <algorithm>
#include <cmath>

namespace ionskin::study {
namespace {

/// Work of a batch beyond the mechanics that it shares, as a multiple of that mechanics.
constexpr double added_work = 4;

struct GroupCost {
  double shared = 0;       ///< time of one contact solution [s]
  double per_solution = 0; ///< time of each further contact solution [s]
  double per_point = 0;    ///< time of the ion transport of a point [s]
};

/// Number of points per batch when they are divided evenly among as few batches as `added_work`
/// allows.
std::size_t points_per_batch(const GroupCost& cost, std::size_t points, std::size_t solutions) {
  const auto count = static_cast<double>(points);
  const double added = cost.per_point + cost.per_solution * static_cast<double>(solutions) / count;
  const double fitting = std::clamp(std::floor(added_work * cost.shared / added), 1.0, count);
  return static_cast<std::size_t>(std::ceil(count / std::ceil(count / fitting)));
}

void estimate(const SweepPoint& point, const GroupCost& cost, Studies studies, SweepBatch& batch) {
  const planning::CostEstimate single = planning::estimate_cost(point.input, batch.threads);
  const auto points = static_cast<double>(batch.points.size());
  batch.seconds = cost.shared + cost.per_solution * static_cast<double>(batch.solutions - 1) +
                  cost.per_point * points;
  const double together = solutions_memory(point.input, batch.solutions);
  const double ions = studies == Studies::mechanics
                          ? 0
                          : electrochemistry::estimate_problem_size(point.input).memory;
  const double at_once = std::min(points, static_cast<double>(batch.threads));
  batch.memory = single.memory + std::max(together, ions * (at_once - 1));
}

void add_batches(const std::vector<SweepPoint>& points, const MechanicsGroup& group,
                 Studies studies, int threads, std::vector<SweepBatch>& batches) {
  const planning::CostEstimate single =
      planning::estimate_cost(points[group.first_point()].input, threads);
  const GroupCost cost{single.mechanics_seconds, single.further_seconds,
                       studies == Studies::mechanics ? 0 : single.ion_seconds};
  std::size_t count = 0;
  for (const auto& solution : group.solutions) {
    count += solution.size();
  }
  const std::size_t most = points_per_batch(cost, count, group.solutions.size());
  const std::size_t first_batch = batches.size();
  for (const auto& solution : group.solutions) {
    bool counted = false;
    for (const std::size_t i : solution) {
      if (batches.size() == first_batch || batches.back().points.size() == most) {
        batches.emplace_back().threads = threads;
        counted = false;
      }
      batches.back().points.push_back(i);
      batches.back().solutions += counted ? 0 : 1;
      counted = true;
    }
  }
  for (std::size_t b = first_batch; b < batches.size(); ++b) {
    std::sort(batches[b].points.begin(), batches[b].points.end());
    estimate(points[group.first_point()], cost, studies, batches[b]);
  }
}

} // namespace

std::vector<SweepBatch> plan_batches(const std::vector<SweepPoint>& points, Studies studies,
                                     int threads) {
  std::vector<SweepBatch> batches;
  for (const MechanicsGroup& group : mechanics_groups(points)) {
    add_batches(points, group, studies, threads, batches);
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i].mechanics_hash.empty()) {
      SweepBatch& batch = batches.emplace_back();
      batch.points = {i};
      batch.threads = threads;
    }
  }
  return batches;
}

} // namespace ionskin::study
