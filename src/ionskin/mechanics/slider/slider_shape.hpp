// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"

#include <array>
#include <memory>
#include <vector>

namespace ionskin::mechanics {

/// The face of a slider that presses on the skin; it must outlive this.
class Underside {
public:
  explicit Underside(const Slider& slider);
  /// Height above its lowest point at a place from the slider's centre [m];
  /// `shapes::unreachable_gap` beyond its plan.
  double gap(double x, double y) const;

private:
  shapes::Plan plan_;
  std::unique_ptr<const shapes::Shape> shape_;
  bool sharp_;
  double lowest_;
};

/// Means of the gap over the cells of a tensor grid, x fastest [m].
/// @param lines_x,lines_y cell edges from the slider's centre [m]
/// @param reflect coordinates that run against the slider's own
std::vector<double> mean_gap(const Slider& slider, const std::vector<double>& lines_x,
                             const std::vector<double>& lines_y,
                             const std::array<bool, 2>& reflect);

} // namespace ionskin::mechanics
