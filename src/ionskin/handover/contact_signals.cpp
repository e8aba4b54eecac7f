// SPDX-License-Identifier: Apache-2.0
#include "ionskin/handover/contact_signals.hpp"

#include "ionskin/handover/surface_instant.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ionskin::handover {
namespace {

/// Mean slip of one step, averaged by area over the cells that touch after it [m]; 0 if no cell
/// does.
double mean_slip(const SurfaceInstant& before, const SurfaceInstant& after,
                 const std::vector<double>& areas) {
  double sum = 0, touching = 0;
  for (std::size_t cell = 0; cell < areas.size(); ++cell) {
    if (after.force[cell][0] > 0) {
      const auto slip = after.slip(before, cell);
      sum += areas[cell] * std::hypot(slip[1], slip[2]);
      touching += areas[cell];
    }
  }
  return touching > 0 ? sum / touching : 0;
}

} // namespace

ContactSignals contact_signals(const ContactTimeline& timeline,
                               const mechanics::ContactSolution& contact) {
  const std::vector<double> areas = cell_areas(contact);
  ContactSignals signals;
  SurfaceInstant before;
  double slip = 0;
  for (std::size_t i = 0; i < timeline.sample_times().size(); ++i) {
    const StateCombination combination = timeline.at_sample(i);
    SurfaceInstant now = surface_instant(combination, areas);
    const double area = std::max(0.0, combination.contact_area());
    const bool touches = area > 0;
    slip = touches && i > 0 ? slip + mean_slip(before, now, areas) : 0;
    signals.area.push_back(area);
    signals.stick_share.push_back(touches ? std::clamp(combination.stick_area() / area, 0.0, 1.0)
                                          : 0);
    signals.slip.push_back(slip);
    before = std::move(now);
  }
  return signals;
}

} // namespace ionskin::handover
