// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/engine/driven_steps.hpp"

#include "ionskin/base/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace ionskin::mechanics {
namespace {

/// Length of the first step after a landing, over the natural period; without a mass, over the
/// duration of the leg [1].
constexpr double first_of_period = 0.01, first_of_leg = 1.0 / 1024;
/// Largest and smallest ratio of successive steps, and share of the tolerance that a step aims at
/// [1].
constexpr double longest_growth = 1.5, shortest_shrink = 0.3, aim = 0.8;
/// Number of times that a step is shortened because the slider did not end where it was predicted.
/// After that the step is accepted, because the slider jumps.
constexpr int most_rejections = 12;
constexpr int most_failures = 10; ///< number of times that a step without a solution is halved
/// Shortest step over the natural period; without a mass, over the duration of the leg [1].
constexpr double shortest = 1e-6;
/// Largest travel of the drive in a step while cells stick, over its travel from no pull to full
/// slip [1].
constexpr double share_of_onset = 0.05;

/// Position and velocity of the drive's end at a fraction of a leg.
DriveEnd end_at(const MotionLeg& leg, double fraction) {
  DriveEnd end{fraction == 1 ? leg.to : leg.centre(fraction * leg.duration), {}};
  for (std::size_t c = 0; c < 2 && leg.duration > 0; ++c) {
    end.velocity[c] = (leg.to[c] - leg.from[c]) / leg.duration;
  }
  return end;
}

double distance(const std::array<double, 2>& a, const std::array<double, 2>& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1]);
}

} // namespace

DrivenSteps::DrivenSteps(SlidingContact& contact, const DriveOptions& options, double meshed_share)
    : LegSteps(contact), options_(options), drive_(options.drive, meshed_share, options.along),
      meshed_share_(meshed_share) {}

void DrivenSteps::land(const MotionLeg& leg, double fraction) {
  drive_.hold(end_at(leg, fraction));
  const double period = options_.drive.natural_period();
  longest_ = period > 0 ? first_of_period * period : first_of_leg * leg.duration;
}

std::array<double, 2> DrivenSteps::centre(const MotionLeg& /*leg*/, double /*fraction*/) const {
  return contact().place();
}

std::array<double, 2> DrivenSteps::drive_force(const MotionLeg& leg, double fraction) const {
  return drive_.force(end_at(leg, fraction));
}

/// Longest next step [s]: limited by the last step and, while cells stick, so that the pull of the
/// drive grows by small parts of the friction limit. Oscillations of the slider on the elastic skin
/// are not resolved.
double DrivenSteps::longest_step(const MotionLeg& leg) const {
  double longest = longest_ > 0 ? longest_ : std::numeric_limits<double>::infinity();
  if (leg.length() > 0 && contact().in_contact() && contact().sticks()) {
    const ContactProblem& problem = contact().problem();
    double limit = 0;
    for (int cell = 0; cell < problem.cells(); ++cell) {
      limit += problem.friction_limit(
          cell, contact().state().force[3 * static_cast<std::size_t>(cell)], 0, 0);
    }
    const double way = share_of_onset * limit / meshed_share_ / options_.drive.stiffness;
    const double yield = share_of_onset * contact()
                                              .onset_distance(leg.direction(), meshed_share_ < 1,
                                                              leg.length(), leg.duration)
                                              .whole;
    if (way + yield > 0) {
      longest = std::min(longest, (way + yield) / leg.length() * leg.duration);
    }
  }
  return longest;
}

void DrivenSteps::require_room(double time) const {
  const auto& place = contact().place();
  for (std::size_t c = 0; c < 2; ++c) {
    if (options_.along[c] &&
        (place[c] < options_.room.low[c] || place[c] > options_.room.high[c])) {
      throw SolverError(
          fmt::format("the slider swings too far on its drive: at {:.4g} s its centre is at "
                      "{:.4g} mm along {}, and it must stay from {:.4g} mm to {:.4g} mm",
                      time, place[c] * 1e3, c == 0 ? "x" : "y", options_.room.low[c] * 1e3,
                      options_.room.high[c] * 1e3),
          "raise motion.drive.stiffness or motion.drive.damping, lower motion.drive.mass, or move "
          "the path away from the skin's edge");
    }
  }
}

void DrivenSteps::require_progress(double time, double time_step) {
  if (++tries_ <= options_.most_tries) {
    return;
  }
  const bool light = options_.drive.mass == 0;
  throw SolverError(
      fmt::format("the slider on its drive makes no progress: {} contacts were solved up to t = "
                  "{:.9g} s, and "
                  "the next step is of {:.2g} s",
                  options_.most_tries, time, time_step),
      light
          ? "give motion.drive.mass, raise motion.drive.damping, or raise contact.kinetic_friction "
            "towards contact.friction: without a mass nothing but damping bounds the speed of a "
            "slip"
          : "raise motion.drive.mass or motion.drive.damping, lower motion.drive.stiffness, or "
            "shorten the motion: every swing is resolved");
}

double DrivenSteps::advance(const MotionLeg& leg, const LegLevels& levels, double from, double to,
                            const PassedSink& passed) {
  const double wanted = to;
  to = std::min(to, from + longest_step(leg) / leg.duration);
  const double tolerance = options_.tolerance * std::max(yield_, options_.longest_travel);
  const double period = options_.drive.natural_period();
  const double least = shortest * (period > 0 ? period : leg.duration);
  SlidingContact::Moment before = contact().moment();
  int failures = 0, rejections = 0;
  while (true) {
    const double time_step = (to - from) * leg.duration;
    const DriveEnd end = end_at(leg, to);
    require_progress(leg.begin + from * leg.duration, time_step);
    try {
      contact().step_yielding(time_step, drive_.guide(time_step, end), levels.load(to));
    } catch (const SolverError&) {
      if (++failures > most_failures) {
        throw;
      }
      to = 0.5 * (from + to);
      continue;
    }
    const double surprise = drive_.surprise(time_step, contact().place()) / tolerance;
    const double travel = distance(contact().place(), drive_.place()) / options_.longest_travel;
    // The error of position grows about with the cube of the step, travel in proportion to it.
    const double scale = std::min(surprise > 0 ? std::cbrt(aim / surprise) : longest_growth,
                                  travel > 0 ? aim / travel : longest_growth);
    if ((surprise > 1 || travel > 1) && rejections < most_rejections && time_step > least) {
      ++rejections;
      contact().go_back(before);
      to = from + (to - from) * std::clamp(scale, shortest_shrink, aim);
      continue;
    }
    drive_.accept(time_step, contact().place(), end);
    if (rejections > 0 || failures > 0 || longest_ == 0 || to < wanted || scale < 1) {
      longest_ = time_step * std::clamp(scale, shortest_shrink, longest_growth);
    } else {
      longest_ = std::max(longest_, time_step * longest_growth);
    }
    longest_ = std::max(longest_, least);
    yield_ = std::max(yield_, distance(end.place, contact().place()));
    require_room(leg.begin + to * leg.duration);
    count_step();
    passed({to, levels.height(to)});
    return to;
  }
}

} // namespace ionskin::mechanics
