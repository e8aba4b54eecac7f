// SPDX-License-Identifier: Apache-2.0
#include "ionskin/poroelasticity/outside_water.hpp"

#include "ionskin/base/value_at.hpp"

#include <algorithm>
#include <cmath>

namespace ionskin::poroelasticity {
namespace {

/// Integral of the waveform of a load from its first instant to `time` [s].
double integral_to(const LoadShares& load, double time) {
  double sum = 0;
  for (std::size_t i = 0; i + 1 < load.time.size() && load.time[i] < time; ++i) {
    const double end = std::min(time, load.time[i + 1]);
    sum +=
        0.5 * (load.share[i] + base::value_at(load.time, load.share, end)) * (end - load.time[i]);
  }
  return sum + load.share.back() * std::max(0.0, time - load.time.back());
}

} // namespace

OutsideWater::OutsideWater(const Case& input, const WaterWalls& walls, double mobility)
    : pressure_{input.water.bottom_pressure, input.water.top_pressure}, walls_(walls),
      thickness_(input.skin.core_thickness()), mobility_(mobility) {
  if (input.strain.kind == StrainSourceKind::prescribed) {
    load_ = load_shares(input.strain);
  }
}

double OutsideWater::steady(double height, double time) const {
  const double top = walls_.share_of_top(height, thickness_);
  return (load_ ? base::value_at(load_->time, load_->share, time) : 1.0) *
         (pressure_[0] * (1 - top) + pressure_[1] * top);
}

double OutsideWater::passed(double time) const {
  return mobility_ * walls_.slope_of_share(thickness_) * (pressure_[0] - pressure_[1]) *
         (load_ ? integral_to(*load_, time) : time);
}

double OutsideWater::largest() const {
  return std::max(std::abs(pressure_[0]), std::abs(pressure_[1]));
}

} // namespace ionskin::poroelasticity
