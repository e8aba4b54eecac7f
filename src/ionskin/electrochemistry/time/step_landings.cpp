// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/time/step_landings.hpp"

#include <algorithm>
#include <cmath>

namespace ionskin::electrochemistry {
namespace {

/// Difference [s] within which two instants count as one.
double same_instant(const history::CoreHistory& history) {
  return 1e-12 * history.duration();
}

bool is_among(const std::vector<double>& instants, double instant, double resolution) {
  const auto from = std::lower_bound(instants.begin(), instants.end(), instant - resolution);
  return from != instants.end() && *from <= instant + resolution;
}

} // namespace

std::size_t StepLandings::behind(double instant) const {
  return static_cast<std::size_t>(std::upper_bound(time.begin(), time.end(), instant) -
                                  time.begin());
}

StepLandings make_step_landings(const history::CoreHistory& history,
                                const std::vector<double>& field_times,
                                const std::vector<double>& switches) {
  const double resolution = same_instant(history);
  StepLandings landings;
  landings.time = history.time;
  std::vector<double> fields;
  for (const double instant : field_times) {
    const double inside = std::clamp(instant, history.time.front(), history.time.back());
    fields.push_back(inside);
    // An instant next to a sample counts as that sample.
    if (!is_among(history.time, inside, resolution)) {
      landings.time.push_back(inside);
    }
  }
  for (const double instant : switches) {
    if (!is_among(history.time, instant, resolution)) {
      landings.time.push_back(instant);
    }
  }
  std::sort(fields.begin(), fields.end());
  std::sort(landings.time.begin(), landings.time.end());
  const auto same = [resolution](double a, double b) { return b - a <= resolution; };
  landings.time.erase(std::unique(landings.time.begin(), landings.time.end(), same),
                      landings.time.end());
  std::vector<double> events = history.event_time;
  events.insert(events.end(), switches.begin(), switches.end());
  std::sort(events.begin(), events.end());
  for (const double instant : landings.time) {
    landings.is_event.push_back(is_among(events, instant, resolution));
    landings.is_field.push_back(is_among(fields, instant, resolution));
  }
  return landings;
}

} // namespace ionskin::electrochemistry
