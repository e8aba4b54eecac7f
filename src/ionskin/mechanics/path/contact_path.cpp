// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/path/contact_path.hpp"

#include "ionskin/mechanics/path/steady_sliding.hpp"

#include <algorithm>
#include <cmath>

namespace ionskin::mechanics {
namespace {

/// Of the surface's displacement in steady sliding: less than this needs no onset.
constexpr double negligible_onset = 1e-6;

bool is_flat(const ContactProblem& problem) {
  return std::all_of(problem.gap.begin(), problem.gap.end(), [](double gap) { return gap == 0; });
}

bool is_loaded(const CellVector& force) {
  return std::any_of(force.begin(), force.end(), [](double value) { return value != 0; });
}

/// Length of the mean difference of the tangential displacement; along y the two halves of a half
/// model cancel.
double mean_tangential_distance(const CellVector& a, const CellVector& b, bool half_model) {
  std::array<double, 2> sum{};
  for (std::size_t at = 0; at < a.size(); at += 3) {
    sum[0] += a[at + 1] - b[at + 1];
    sum[1] += half_model ? 0 : a[at + 2] - b[at + 2];
  }
  return std::hypot(sum[0], sum[1]) / (static_cast<double>(a.size()) / 3);
}

} // namespace

SliderLoad load_of(const SliderLevel& level, double meshed_share) {
  if (level.is_force) {
    return {LoadKind::force, level.value * meshed_share};
  }
  return {LoadKind::indentation, std::max(0.0, -level.value)};
}

SliderLoad load_of(const ContactPart& part, double fraction, double meshed_share) {
  const SliderLoad from = load_of(part.from_level, meshed_share),
                   to = load_of(part.to_level, meshed_share);
  return {to.kind, fraction == 1 ? to.value : from.value + fraction * (to.value - from.value)};
}

void ContactPath::start_detached(const CellVector& surface) {
  state_ = {};
  state_.force.assign(3 * problem_.area.size(), 0.0);
  state_.surface = surface.empty() ? state_.force : surface;
}

void ContactPath::start_sliding(const SliderLevel& level, const std::array<double, 2>& direction) {
  state_ = steady_sliding(problem_, load_of(level, meshed_share_), direction, 0);
}

void ContactPath::step(const SliderLoad& load, const std::array<double, 2>& travel,
                       double time_step) {
  state_ = solve_contact_step(problem_, {load, travel, time_step, state_.surface}, state_.force);
}

LegPath ContactPath::follow(const MotionLeg& leg, const std::array<double, 2>& direction) {
  if (leg.slides()) {
    return slide(leg, direction);
  }
  return leg.from_level.is_force && leg.to_level.is_force ? press_by_force(leg) : press(leg);
}

LegPath ContactPath::press_by_force(const MotionLeg& leg) {
  LegPath path;
  if (leg.from_level == leg.to_level) {
    return path; // nothing happens while the slider rests
  }
  const ContactPart part = contact_part(leg);
  for (int i = 1; i <= steps_.lift_off; ++i) {
    const double fraction = static_cast<double>(i) / steps_.lift_off;
    step(load_of(part, fraction, meshed_share_), {0, 0}, leg.duration / steps_.lift_off);
    path.points.push_back({leg.duration * fraction, state_});
  }
  return path;
}

LegPath ContactPath::press(const MotionLeg& leg) {
  LegPath path;
  const SliderLoad last = load_of(leg.to_level, meshed_share_);
  double indentation = last.value;
  if (last.kind == LoadKind::force) {
    indentation =
        solve_contact_step(problem_, {last, {0, 0}, leg.duration, state_.surface}, state_.force)
            .indentation;
  }
  const bool fresh = leg.lands();
  const double before = fresh ? 0 : state_.indentation;
  const double from_height = leg.from_level.is_force ? -before : leg.from_level.value;
  const double to_height = leg.to_level.is_force ? -indentation : leg.to_level.value;
  if (from_height == to_height) {
    return path;
  }
  const auto time_of = [&](double reached) {
    return leg.duration * (from_height + reached) / (from_height - to_height);
  };
  path.begin = fresh ? time_of(0) : 0;
  // From no load the problem of a flat slider is homogeneous in the indentation.
  const int count = !fresh ? steps_.lift_off : is_flat(problem_) ? 1 : steps_.touchdown;
  for (int i = 1; i <= count; ++i) {
    const double fraction = static_cast<double>(i) / count;
    const double wanted = before + fraction * (indentation - before);
    const double time = i < count || leg.leaves() ? time_of(wanted) : leg.duration;
    const double earlier = path.points.empty() ? path.begin : path.points.back().time;
    step(i < count ? SliderLoad{LoadKind::indentation, wanted} : last, {0, 0}, time - earlier);
    path.points.push_back({time, state_});
  }
  return path;
}

double ContactPath::onset_travel(const SurfaceState& steady) const {
  const bool half_model = meshed_share_ < 1;
  const double distance = mean_tangential_distance(steady.surface, state_.surface, half_model);
  const double scale =
      mean_tangential_distance(steady.surface, CellVector(steady.surface.size(), 0.0), half_model);
  return distance > negligible_onset * scale ? steps_.onset_travel_ratio * distance : 0;
}

LegPath ContactPath::slide(const MotionLeg& leg, const std::array<double, 2>& direction) {
  const ContactPart part = contact_part(leg);
  const double length = std::hypot(part.to[0] - part.from[0], part.to[1] - part.from[1]);
  const double speed = length / part.duration;
  const auto load_at = [&](double travel) { return load_of(part, travel / length, meshed_share_); };
  const bool constant_load = part.from_level == part.to_level;

  LegPath path;
  path.begin = path.joined = part.begin;
  path.steady = true;
  if (problem_.friction.coefficient == 0) {
    return path;
  }
  const double whole = onset_travel(
      steady_sliding(problem_, load_at(is_loaded(state_.force) ? 0 : length), direction, 0));
  const double total = (std::pow(steps_.onset_growth, steps_.onset) - 1) /
                       (steps_.onset_growth - 1); // of all increments over the first
  const double last_increment = std::pow(steps_.onset_growth, steps_.onset - 1) / total;
  path.steady = whole * (1 + last_increment) < length;
  if (whole == 0) {
    return path;
  }
  const double onset = path.steady ? whole : length;
  path.joined = part.begin + onset * (1 + last_increment) / speed;
  double increment = onset / total, travel = 0;
  for (int i = 0; i < steps_.onset; ++i) {
    travel = i + 1 == steps_.onset ? onset : travel + increment;
    step(load_at(travel), {increment * direction[0], increment * direction[1]}, increment / speed);
    path.points.push_back({part.begin + travel / speed, state_});
    if (path.steady && !constant_load) {
      path.reference.push_back(steady_sliding(problem_, load_at(travel), direction, 0));
    }
    increment *= steps_.onset_growth;
  }
  return path;
}

} // namespace ionskin::mechanics
