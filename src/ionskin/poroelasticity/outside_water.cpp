// SPDX-License-Identifier: Apache-2.0
#include "ionskin/poroelasticity/outside_water.hpp"

#include "ionskin/poroelasticity/prescribed_load.hpp"

#include <algorithm>
#include <cmath>

namespace ionskin::poroelasticity {
namespace {

using Samples = std::vector<std::pair<double, double>>;

/// The value at a time of what is linear between samples and constant beyond them.
double value_at(const Samples& samples, double time) {
  const auto next = std::ranges::upper_bound(samples, time, {}, &Samples::value_type::first);
  if (next == samples.begin() || next == samples.end()) {
    return next == samples.begin() ? samples.front().second : samples.back().second;
  }
  const auto& [begin, from] = *(next - 1);
  return from + (next->second - from) * (time - begin) / (next->first - begin);
}

/// The integral of it from the first sample on.
double integral_to(const Samples& samples, double time) {
  double sum = 0;
  for (std::size_t i = 0; i + 1 < samples.size() && samples[i].first < time; ++i) {
    const double end = std::min(time, samples[i + 1].first);
    sum += 0.5 * (samples[i].second + value_at(samples, end)) * (end - samples[i].first);
  }
  return sum + samples.back().second * std::max(0.0, time - samples.back().first);
}

} // namespace

OutsideWater::OutsideWater(const Case& input, const WaterWalls& walls, double mobility)
    : pressure_{input.water.bottom_pressure, input.water.top_pressure}, walls_(walls),
      thickness_(input.skin.core_thickness()), mobility_(mobility) {
  if (input.strain.kind == StrainSourceKind::prescribed) {
    share_ = load_shares(input.strain);
  }
}

double OutsideWater::steady(double height, double time) const {
  const double top = walls_.share_of_top(height, thickness_);
  return (share_.empty() ? 1.0 : value_at(share_, time)) *
         (pressure_[0] * (1 - top) + pressure_[1] * top);
}

double OutsideWater::passed(double time) const {
  return mobility_ * walls_.slope_of_share(thickness_) * (pressure_[0] - pressure_[1]) *
         (share_.empty() ? time : integral_to(share_, time));
}

double OutsideWater::largest() const {
  return std::max(std::abs(pressure_[0]), std::abs(pressure_[1]));
}

} // namespace ionskin::poroelasticity
