// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/path/contact_reach.hpp"

#include "ionskin/base/system/interrupt.hpp"
#include "ionskin/case/slider_motion.hpp"
#include "ionskin/mechanics/path/steady_sliding.hpp"
#include "ionskin/mechanics/slider/turning_underside.hpp"
#include "ionskin/mechanics/surface/contact_solver.hpp"
#include "ionskin/mesh/footprint.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

namespace ionskin::mechanics {
namespace {

/// Heaviest loads of a case on the meshed part.
std::vector<SliderLoad> heaviest_loads(const Case& input, bool half_model) {
  const mesh::HeaviestLoad heaviest = mesh::heaviest_load(input);
  std::vector<SliderLoad> loads;
  if (heaviest.indentation > 0) {
    loads.push_back({LoadKind::indentation, heaviest.indentation});
  }
  if (heaviest.force > 0) {
    loads.push_back({LoadKind::force, heaviest.force / (half_model ? 2 : 1)});
  }
  return loads;
}

/// Directions of the slides, as unit vectors. For a path with many directions, four directions
/// stand for all.
std::vector<std::array<double, 2>> slide_directions(const Case& input) {
  constexpr std::size_t most = 8;
  std::set<std::array<double, 2>> directions;
  for (const MotionLeg& leg : motion_legs(input.motion, input.slider)) {
    if (leg.slides() && directions.size() <= most) {
      directions.insert(leg.direction());
    }
  }
  if (directions.size() > most) {
    const double diagonal = std::sqrt(0.5);
    return {{1, 0}, {0, 1}, {diagonal, diagonal}, {diagonal, -diagonal}};
  }
  return {directions.begin(), directions.end()};
}

} // namespace

void ContactReach::include(const std::array<std::span<const double>, 2>& lines,
                           std::span<const double> load, std::size_t stride) {
  constexpr double rounding = 1 - 1e-9;
  const std::size_t columns = lines[0].size() - 1;
  for (std::size_t cell = 0; stride * cell < load.size(); ++cell) {
    if (load[stride * cell] == 0) {
      continue;
    }
    const std::array<std::size_t, 2> at{cell % columns, cell / columns};
    for (std::size_t d = 0; d < 2; ++d) {
      const double furthest = std::max(-lines[d][at[d]], lines[d][at[d] + 1]);
      extent[d] = std::max(extent[d], furthest);
      border[d] = border[d] || furthest >= -lines[d].front() * rounding;
    }
  }
}

void ContactReach::include(const ContactReach& other) {
  for (std::size_t d = 0; d < 2; ++d) {
    extent[d] = std::max(extent[d], other.extent[d]);
    border[d] = border[d] || other.border[d];
  }
}

namespace {

/// Poses of the slider while it may touch, sampled along turns. Of many poses, some that are spread
/// over all of them.
std::vector<shapes::Pose> poses_in_contact(const Case& input) {
  constexpr std::size_t most = 24;
  constexpr double each_turn = 0.2; // [rad]
  std::vector<shapes::Pose> poses;
  for (const MotionLeg& leg : motion_legs(input.motion, input.slider)) {
    if (!leg.touches()) {
      continue;
    }
    const int parts =
        1 +
        static_cast<int>(std::min(1e3, std::abs(leg.to_pose.yaw - leg.from_pose.yaw) / each_turn));
    for (int i = poses.empty() ? 0 : 1; i <= parts; ++i) {
      const shapes::Pose pose = leg.pose(leg.duration * i / parts);
      if (poses.empty() || pose != poses.back()) {
        poses.push_back(pose);
      }
    }
  }
  if (poses.size() > most) {
    std::vector<shapes::Pose> some;
    for (std::size_t i = 0; i < most; ++i) {
      some.push_back(poses[i * (poses.size() - 1) / (most - 1)]);
    }
    return some;
  }
  return poses;
}

/// Reach of the contact under the heaviest loads in one pose.
/// @param gap mean height of the underside over each cell in that pose [m]
ContactReach reach_in_pose(const Case& input, const SkinModel& model,
                           const std::vector<double>& gap, const std::array<double, 2>& centre,
                           double friction) {
  base::check_interrupt();
  ContactProblem problem{{},
                         model.cells.area,
                         gap,
                         laws::friction(input.contact.law, friction, input.contact.parameters)};
  ContactCompliance(model).at(centre, problem);
  const CellVector none(3 * model.cells.count(), 0.0);
  ContactReach reach;
  const auto include = [&](const SurfaceState& state) {
    reach.include({model.cells.lines_x, model.cells.lines_y}, state.force, 3);
  };
  for (const SliderLoad& load : heaviest_loads(input, model.mesh.half_model())) {
    include(solve_contact_step(problem, {load, {0, 0}, 0, none}, none));
    if (problem.friction.adhesion.pulls()) {
      continue; // `widened_footprint` follows where sliding reaches the border
    }
    for (const auto& way : slide_directions(input)) {
      for (const double sign : {1.0, -1.0}) {
        include(steady_sliding(problem, load, {sign * way[0], sign * way[1]}, 0));
      }
    }
  }
  return reach;
}

} // namespace

ContactReach hardest_reach(const Case& input, const SkinModel& model,
                           const std::array<double, 2>& centre, double friction) {
  if (!input.slider.changing.any()) {
    return reach_in_pose(input, model, model.gap, centre, friction);
  }
  ContactReach reach;
  const TurningUnderside underside(input.slider, model.cells);
  for (const shapes::Pose& pose : poses_in_contact(input)) {
    reach.include(reach_in_pose(input, model, underside.gap(pose), centre, friction));
  }
  return reach;
}

} // namespace ionskin::mechanics
