// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/slider/turning_underside.hpp"

#include "ionskin/mechanics/slider/slider_shape.hpp"

#include <cstddef>

namespace ionskin::mechanics {

std::vector<double> TurningUnderside::gap(const shapes::Pose& pose) const {
  return mean_gap(slider_, pose, cells_.lines_x, cells_.lines_y, {false, false});
}

std::vector<std::array<double, 2>> TurningUnderside::turn(double angle) const {
  std::vector<std::array<double, 2>> result;
  for (std::size_t cell = 0; cell < cells_.count(); ++cell) {
    const auto arm = cells_.middle(cell);
    result.push_back({-angle * arm[1], angle * arm[0]});
  }
  return result;
}

std::vector<std::array<double, 3>> TurningUnderside::place(const shapes::Pose& pose,
                                                           const std::vector<double>& gap) const {
  const auto turned = turn(pose.yaw);
  std::vector<std::array<double, 3>> result;
  for (std::size_t cell = 0; cell < gap.size(); ++cell) {
    result.push_back({-gap[cell], turned[cell][0], turned[cell][1]});
  }
  return result;
}

} // namespace ionskin::mechanics
