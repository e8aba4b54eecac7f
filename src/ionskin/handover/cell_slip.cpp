// SPDX-License-Identifier: Apache-2.0
#include "ionskin/handover/cell_slip.hpp"

#include "ionskin/handover/surface_instant.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>

namespace ionskin::handover {
namespace {

/// Smallest force that counts as contact [N]. Smaller forces are left of the state before by
/// rounding of the instant.
double least_force(const SurfaceInstant& instant) {
  double largest = 0;
  for (const auto& force : instant.force) {
    largest = std::max(largest, force[0]);
  }
  return 1e-9 * largest;
}

} // namespace

std::vector<std::vector<double>> slip_since_landing(const ContactTimeline& timeline,
                                                    const mechanics::ContactSolution& contact,
                                                    const std::vector<double>& instants) {
  const std::vector<double> areas = cell_areas(contact);
  std::vector<std::vector<double>> result(instants.size());
  std::multimap<double, std::size_t> asked;
  for (std::size_t i = 0; i < instants.size(); ++i) {
    asked.emplace(instants[i], i);
  }
  std::vector<double> stops = timeline.sample_times();
  stops.insert(stops.end(), instants.begin(), instants.end());
  std::ranges::sort(stops);
  std::vector<double> slip(areas.size(), 0.0);
  SurfaceInstant before = surface_instant(timeline.at(stops.front()), areas);
  for (const double stop : stops) {
    SurfaceInstant now = surface_instant(timeline.at(stop), areas);
    const double least = least_force(now);
    for (std::size_t cell = 0; cell < areas.size(); ++cell) {
      if (now.force[cell][0] > least) {
        const auto way = now.slip(before, cell);
        slip[cell] += std::hypot(way[1], way[2]);
      } else {
        slip[cell] = 0;
      }
    }
    const auto [first, last] = asked.equal_range(stop);
    for (auto at = first; at != last; ++at) {
      result[at->second] = slip;
    }
    before = std::move(now);
  }
  return result;
}

} // namespace ionskin::handover
