// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/slider_motion.hpp"

#include "ionskin/base/error.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace ionskin {

namespace {

using Point = std::array<double, 2>;

Point between(const Point& from, const Point& to, double fraction) {
  if (fraction == 1)
    return to;
  return {from[0] + fraction * (to[0] - from[0]), from[1] + fraction * (to[1] - from[1])};
}

/// Builds a cycle leg by leg; each leg starts where the one before ends.
class Cycle {
public:
  Cycle(const Point& start, const SliderLevel& level, const shapes::Pose& pose)
      : place_(start), level_(level), pose_(pose) {}

  void add(Phase phase, double duration, const Point& to, const SliderLevel& level) {
    add(phase, duration, to, level, pose_);
  }
  void add(Phase phase, double duration, const Point& to, const SliderLevel& level,
           const shapes::Pose& pose) {
    const double begin = legs_.empty() ? 0 : legs_.back().end();
    legs_.push_back({phase, begin, duration, place_, to, level_, level, pose_, pose});
    place_ = to;
    level_ = level;
    pose_ = pose;
  }
  void reserve(std::size_t legs) { legs_.reserve(legs); }
  std::vector<MotionLeg> take() { return std::move(legs_); }

private:
  Point place_;
  SliderLevel level_;
  shapes::Pose pose_;
  std::vector<MotionLeg> legs_;
};

/// Makes the legs of touchdown, strokes back and forth with rests between them, lift-off and
/// return.
/// @param count number of strokes
std::vector<MotionLeg> strokes(const Motion& motion, const Slider& slider, int count) {
  const SliderLevel above{false, motion.gap};
  const SliderLevel pressed = motion.force_controlled() ? SliderLevel{true, motion.preload_force}
                                                        : SliderLevel{false, -motion.preload};
  const Point start = slider.start;
  const Point end{start[0] + motion.stroke * motion.direction[0],
                  start[1] + motion.stroke * motion.direction[1]};
  Cycle cycle(start, above, slider.pose);
  cycle.add(Phase::touchdown, motion.touchdown, start, pressed);
  for (int i = 0; i < count; ++i) {
    const Point& from = i % 2 == 0 ? start : end;
    if (i > 0 && motion.dwell > 0)
      cycle.add(Phase::slide, motion.dwell, from, pressed);
    cycle.add(Phase::slide, motion.slide, i % 2 == 0 ? end : start, pressed);
  }
  const Point last = count % 2 == 0 ? start : end;
  cycle.add(Phase::lift, motion.lift, last, above);
  cycle.add(Phase::return_, motion.return_, start, above);
  return cycle.take();
}

SliderLevel level_of(const Waypoint& waypoint) {
  return waypoint.force ? SliderLevel{true, *waypoint.force}
                        : SliderLevel{false, waypoint.height.value_or(0)};
}

/// Phase of a leg between two levels. A detached leg belongs to `touchdown` before the first
/// contact and to `return_` after it.
Phase phase_of(const SliderLevel& from, const SliderLevel& to, bool has_touched) {
  if (from.touches())
    return to.touches() ? Phase::slide : Phase::lift;
  return to.touches() || !has_touched ? Phase::touchdown : Phase::return_;
}

shapes::Pose pose_of(const Waypoint& waypoint, const shapes::Pose& otherwise) {
  return {waypoint.roll.value_or(otherwise.roll), waypoint.pitch.value_or(otherwise.pitch),
          waypoint.yaw.value_or(otherwise.yaw)};
}

std::vector<MotionLeg> through_waypoints(const std::vector<Waypoint>& waypoints,
                                         const shapes::Pose& pose) {
  Cycle cycle(waypoints.front().position, level_of(waypoints.front()),
              pose_of(waypoints.front(), pose));
  cycle.reserve(waypoints.size() - 1);
  bool has_touched = false;
  for (std::size_t i = 1; i < waypoints.size(); ++i) {
    const SliderLevel from = level_of(waypoints[i - 1]), to = level_of(waypoints[i]);
    cycle.add(phase_of(from, to, has_touched), waypoints[i].time - waypoints[i - 1].time,
              waypoints[i].position, to, pose_of(waypoints[i], pose));
    has_touched = has_touched || to.touches();
  }
  return cycle.take();
}

} // namespace

std::string name(Phase phase) {
  switch (phase) {
  case Phase::touchdown:
    return "touchdown";
  case Phase::slide:
    return "slide";
  case Phase::lift:
    return "lift";
  case Phase::return_:
    return "return";
  }
  throw InternalError("a phase without a name");
}

double MotionLeg::length() const {
  return std::hypot(to[0] - from[0], to[1] - from[1]);
}

Point MotionLeg::direction() const {
  const double way = length();
  return way > 0 ? Point{(to[0] - from[0]) / way, (to[1] - from[1]) / way} : Point{};
}

Point MotionLeg::centre(double since_begin) const {
  return between(from, to, duration > 0 ? std::clamp(since_begin / duration, 0.0, 1.0) : 1.0);
}

shapes::Pose MotionLeg::pose(double since_begin) const {
  if (!turns()) {
    return to_pose;
  }
  const double part = duration > 0 ? std::clamp(since_begin / duration, 0.0, 1.0) : 1.0;
  const auto at = [&](double first, double last) {
    return part == 1 ? last : first + part * (last - first);
  };
  return {at(from_pose.roll, to_pose.roll), at(from_pose.pitch, to_pose.pitch),
          at(from_pose.yaw, to_pose.yaw)};
}

double Drive::natural_period() const {
  return given() ? 2 * std::numbers::pi * std::sqrt(mass / stiffness) : 0;
}

double Motion::cycle_duration() const {
  switch (kind) {
  case MotionKind::touch_slide_lift:
    return touchdown + slide + lift + return_;
  case MotionKind::reciprocating:
    return touchdown + strokes * slide + (strokes - 1) * dwell + lift + return_;
  case MotionKind::waypoints:
    return waypoints.empty() ? 0 : waypoints.back().time;
  }
  throw InternalError("a kind of motion without duration");
}

std::vector<MotionLeg> motion_legs(const Motion& motion, const Slider& slider) {
  switch (motion.kind) {
  case MotionKind::touch_slide_lift:
    return strokes(motion, slider, 1);
  case MotionKind::reciprocating:
    return strokes(motion, slider, motion.strokes);
  case MotionKind::waypoints:
    return through_waypoints(motion.waypoints, slider.pose);
  }
  throw InternalError("a kind of motion without legs");
}

void settle_pose(Case& input) {
  if (input.motion.kind != MotionKind::waypoints || input.motion.waypoints.empty())
    return;
  Slider& slider = input.slider;
  for (Waypoint& waypoint : input.motion.waypoints) {
    const shapes::Pose pose = pose_of(waypoint, slider.pose);
    waypoint.roll = pose.roll;
    waypoint.pitch = pose.pitch;
    waypoint.yaw = pose.yaw;
  }
  slider.pose = pose_of(input.motion.waypoints.front(), slider.pose);
  for (const MotionLeg& leg : motion_legs(input.motion, slider)) {
    slider.changing.roll = slider.changing.roll || leg.from_pose.roll != leg.to_pose.roll;
    slider.changing.pitch = slider.changing.pitch || leg.from_pose.pitch != leg.to_pose.pitch;
    slider.changing.yaw = slider.changing.yaw || leg.from_pose.yaw != leg.to_pose.yaw;
  }
}

ContactPart contact_part(const MotionLeg& leg) {
  ContactPart part{0, leg.duration, leg.from, leg.to, leg.from_level, leg.to_level};
  if (leg.from_level.is_force || leg.to_level.is_force)
    return part;
  const double from = leg.from_level.value, to = leg.to_level.value;
  if (leg.lands()) {
    const double detached = from / (from - to);
    part.begin = detached * leg.duration;
    part.from = between(leg.from, leg.to, detached);
    part.from_level.value = 0;
  } else if (leg.leaves()) {
    const double touching = from / (from - to);
    part.to = between(leg.from, leg.to, touching);
    part.to_level.value = 0;
    part.duration = touching * leg.duration;
    return part;
  }
  part.duration = leg.duration - part.begin;
  return part;
}

MotionBox motion_box(const Motion& motion, const Slider& slider) {
  const std::vector<MotionLeg> legs = motion_legs(motion, slider);
  MotionBox box{legs.front().from, legs.front().from};
  for (const MotionLeg& leg : legs)
    for (const std::size_t d : {0, 1}) {
      box.low[d] = std::min(box.low[d], leg.to[d]);
      box.high[d] = std::max(box.high[d], leg.to[d]);
    }
  return box;
}

const MotionLeg& first_slide(const std::vector<MotionLeg>& legs) {
  const auto first = [&](auto&& wanted) { return std::find_if(legs.begin(), legs.end(), wanted); };
  auto found = first([](const MotionLeg& leg) { return leg.slides() && !leg.lands(); });
  if (found == legs.end())
    found = first([](const MotionLeg& leg) { return leg.touches() && !leg.lands(); });
  if (found == legs.end())
    found = first([](const MotionLeg& leg) { return leg.touches(); });
  return found == legs.end() ? legs.front() : *found;
}

namespace {

/// Index behind the last leg that continues the slide of the leg `first`; `first` + 1 if none does.
std::size_t end_of_slide(const std::vector<MotionLeg>& legs, std::size_t first) {
  constexpr double least_cosine = 0.995; // cos(0.1 rad)
  std::size_t next = first + 1;
  while (legs[first].slides() && next < legs.size() && legs[next].slides()) {
    const Point before = legs[next - 1].direction(), here = legs[next].direction();
    if (before[0] * here[0] + before[1] * here[1] < least_cosine)
      break;
    ++next;
  }
  return next;
}

/// Joins the legs [first, end) to one leg.
MotionLeg joined(const std::vector<MotionLeg>& legs, std::size_t first, std::size_t end) {
  MotionLeg slide = legs[first];
  if (end - first > 1) {
    slide.duration = legs[end - 1].end() - slide.begin;
    slide.to = legs[end - 1].to;
    slide.to_level = legs[end - 1].to_level;
    slide.to_pose = legs[end - 1].to_pose;
  }
  return slide;
}

} // namespace

MotionLeg whole_slide(const std::vector<MotionLeg>& legs) {
  const auto first = static_cast<std::size_t>(&first_slide(legs) - legs.data());
  return joined(legs, first, end_of_slide(legs, first));
}

std::vector<MotionLeg> joined_slides(const std::vector<MotionLeg>& legs) {
  std::vector<MotionLeg> result;
  for (std::size_t first = 0; first < legs.size();) {
    const std::size_t end = end_of_slide(legs, first);
    result.push_back(joined(legs, first, end));
    first = end;
  }
  return result;
}

Point slide_direction(const std::vector<MotionLeg>& legs) {
  constexpr double least_lead = 0.5; // distance between the ends over the length of the path
  const MotionLeg& first = first_slide(legs);
  const auto index = static_cast<std::size_t>(&first - legs.data());
  double way = 0;
  for (std::size_t i = index; i < end_of_slide(legs, index); ++i)
    way += legs[i].length();
  const MotionLeg whole = whole_slide(legs);
  return whole.length() >= least_lead * way ? whole.direction() : first.direction();
}

} // namespace ionskin
