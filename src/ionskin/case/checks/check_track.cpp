// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/checks/check_track.hpp"

#include "ionskin/case/checks/check_motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace ionskin {

namespace {

struct Axis {
  std::size_t index;
  const char* name;
  const char* extent_key;
  double extent; // of the skin [m]
};

std::vector<Pointer> places(const CaseDocument& document, const Axis& axis, bool at_end) {
  std::vector<Pointer> all;
  const auto append = [&](const std::string& key, const std::string& note) {
    for (const Pointer& pointer : document.point_at(key, note))
      all.push_back(pointer);
  };
  append("slider.start", "centre at the start");
  append("slider.size", "");
  if (at_end)
    append("motion.stroke", "travel");
  append(axis.extent_key, "the skin");
  return all;
}

// Text of the remedy: the centres at the start that keep the slider inside the skin.
std::string remedy(const Axis& axis, double half_size, double travel) {
  const double lowest = half_size + std::max(0.0, -travel);
  const double highest = axis.extent - half_size - std::max(0.0, travel);
  if (lowest >= highest)
    return fmt::format(
        "slider and stroke together need more than {:.6g} mm of the {:.6g} mm along {}: make "
        "them smaller or the skin larger",
        (2 * half_size + std::abs(travel)) * 1e3, axis.extent * 1e3, axis.name);
  return fmt::format(
      "with this size and stroke the start must lie above {:.6g} mm and below {:.6g} mm along {}",
      lowest * 1e3, highest * 1e3, axis.name);
}

bool lies_inside(double low, double high, double extent) {
  const double tolerance = 1e-9 * extent;
  const bool flush = std::abs(low) <= tolerance && std::abs(high - extent) <= tolerance;
  return flush || (low > 0 && high < extent);
}

/// Words for the extent of a slider along an axis, or for its centre where only that counts.
std::string extent_words(double centre, double half_size) {
  return half_size > 0 ? fmt::format("it reaches from {:.6g} mm to {:.6g} mm",
                                     (centre - half_size) * 1e3, (centre + half_size) * 1e3)
                       : fmt::format("its centre is at {:.6g} mm", centre * 1e3);
}

void check_axis(const CaseDocument& document, const Axis& axis, Problems& problems) {
  const Slider& slider = document.input.slider;
  const Motion& motion = document.input.motion;
  const double half_size = slider.flat_half_size()[axis.index];
  const double travel = motion.stroke * motion.direction[axis.index];
  for (const bool at_end : {false, true}) {
    const double centre = slider.start[axis.index] + (at_end ? travel : 0.0);
    const double low = centre - half_size, high = centre + half_size;
    if (lies_inside(low, high, axis.extent))
      continue;
    problems.add(
        fmt::format(
            "the slider is not inside the skin at the {} of the slide: {} along {}, the skin "
            "reaches from 0 mm to {:.6g} mm",
            at_end ? "end" : "start", extent_words(centre, half_size), axis.name,
            axis.extent * 1e3),
        places(document, axis, at_end), remedy(axis, half_size, travel));
    return;
  }
}

void check_waypoints(const CaseDocument& document, const Axis& axis, Problems& problems) {
  const double half_size = document.input.slider.flat_half_size()[axis.index];
  const std::vector<Waypoint>& waypoints = document.input.motion.waypoints;
  for (std::size_t i = 0; i < waypoints.size(); ++i) {
    const double centre = waypoints[i].position[axis.index];
    if (lies_inside(centre - half_size, centre + half_size, axis.extent))
      continue;
    problems.add(
        fmt::format("the slider is not inside the skin at waypoint {}: {} along {}, the skin "
                    "reaches from 0 mm to {:.6g} mm",
                    i + 1, extent_words(centre, half_size), axis.name, axis.extent * 1e3),
        point_at_waypoint(document, i),
        fmt::format(
            "with this size its centre must lie above {:.6g} mm and below {:.6g} mm along {}",
            half_size * 1e3, (axis.extent - half_size) * 1e3, axis.name));
    return;
  }
}

} // namespace

void check_track(const CaseDocument& document, Problems& problems) {
  const Case& input = document.input;
  const bool waypoints = input.motion.kind == MotionKind::waypoints;
  if (!waypoints && input.motion.direction == std::array<double, 2>{0, 0}) {
    problems.add("motion.direction has no length", document.point_at("motion.direction"),
                 "at least one of its two numbers must differ from 0");
    return;
  }
  const auto check = waypoints ? check_waypoints : check_axis;
  check(document, {0, "x", "skin.length", input.skin.length}, problems);
  if (!covers_width(input))
    check(document, {1, "y", "skin.width", input.skin.width}, problems);
}

} // namespace ionskin
