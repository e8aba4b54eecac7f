// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/path/contact_plan.hpp"

#include "ionskin/mechanics/position/interpolation_nodes.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ionskin::mechanics {
namespace {

using Point = std::array<double, 2>;

bool same_place(const Point& a, const Point& b, const Skin& skin) {
  return std::abs(a[0] - b[0]) <= 1e-10 * skin.length &&
         std::abs(a[1] - b[1]) <= 1e-10 * skin.width;
}

PositionTask& task_at(std::vector<PositionTask>& tasks, const Point& canonical, const Skin& skin) {
  const auto task = std::find_if(tasks.begin(), tasks.end(), [&](const PositionTask& other) {
    return same_place(other.centre, canonical, skin);
  });
  if (task != tasks.end()) {
    return *task;
  }
  tasks.push_back({canonical, {}, {}});
  return tasks.back();
}

/// Load steps begin where the slider lands, and after every slide, which may have become steady.
bool begins_chain(const std::vector<MotionLeg>& legs, std::size_t leg) {
  return legs[leg].touches() &&
         (legs[leg].lands() || (leg > 0 && legs[leg - 1].slides() && !legs[leg - 1].leaves()));
}

} // namespace

std::size_t ContactPlan::first_alike(std::size_t leg) const {
  std::size_t first = 0;
  while (!legs[first].repeats(legs[leg])) {
    ++first;
  }
  return first;
}

NodeCounts ContactPlan::node_counts() const {
  NodeCounts counts;
  for (const std::vector<double>& ways : nodes) {
    counts.push_back(ways.size());
  }
  return counts;
}

NodeCounts expected_node_counts(const Case& input) {
  NodeCounts counts;
  for (const MotionLeg& leg : motion_legs(input.motion, input.slider)) {
    const ContactPart part = contact_part(leg);
    counts.push_back(leg.slides() ? expected_node_count(input, part.from, part.to) : 0);
  }
  return counts;
}

ContactPlan plan_contact(const Case& input, const NodeCounts& node_counts) {
  ContactPlan plan;
  plan.legs = motion_legs(input.motion, input.slider);
  plan.nodes.resize(plan.legs.size());
  for (std::size_t leg = 0; leg < plan.legs.size(); ++leg) {
    const ContactPart part = contact_part(plan.legs[leg]);
    const auto position_of = [&](const Point& centre) {
      return canonical_position(input.skin, centre);
    };
    if (begins_chain(plan.legs, leg)) {
      const auto position = position_of(part.from);
      task_at(plan.positions, position.centre, input.skin).chains.push_back({leg, position});
    }
    if (!plan.legs[leg].slides()) {
      continue;
    }
    const Point way{part.to[0] - part.from[0], part.to[1] - part.from[1]};
    const double length = std::hypot(way[0], way[1]);
    plan.nodes[leg] = interpolation_nodes(length, node_counts[leg]);
    if (plan.first_alike(leg) != leg) {
      continue;
    }
    for (std::size_t i = 0; i < plan.nodes[leg].size(); ++i) {
      const double fraction = plan.nodes[leg][i] / length;
      const auto position =
          position_of({part.from[0] + fraction * way[0], part.from[1] + fraction * way[1]});
      task_at(plan.positions, position.centre, input.skin).nodes.push_back({leg, i, position});
    }
  }
  return plan;
}

std::vector<PositionTask> added_positions(const ContactPlan& plan, const ContactPlan& before) {
  std::vector<PositionTask> added;
  for (const PositionTask& task : plan.positions) {
    PositionTask rest{task.centre, {}, {}};
    for (const PositionTask::Node& node : task.nodes) {
      const std::vector<double>& solved = before.nodes[node.leg];
      if (!std::binary_search(solved.begin(), solved.end(), plan.nodes[node.leg][node.index])) {
        rest.nodes.push_back(node);
      }
    }
    if (!rest.nodes.empty()) {
      added.push_back(std::move(rest));
    }
  }
  return added;
}

} // namespace ionskin::mechanics
