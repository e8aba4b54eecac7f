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
  Underside(const Slider& slider, const shapes::Pose& pose);
  /// Height above its lowest point at a place from the slider's centre [m];
  /// `shapes::unreachable_gap` beyond its plan.
  double gap(double x, double y) const;

  /// Mean over a cell between two opposite corners [m]. A cell of which more than half lies beyond
  /// the plan is none of the underside; of others the rest counts.
  double mean_gap(const std::array<double, 2>& low, const std::array<double, 2>& high,
                  const std::array<bool, 2>& reflect) const;

private:
  shapes::Plan plan_;
  std::unique_ptr<const shapes::Shape> shape_;
  bool flat_;
  bool turned_; ///< its edges lie along no cells
  double lowest_;
};

/// Means of the gap over the cells of a tensor grid, x fastest [m].
/// @param lines_x,lines_y cell edges from the slider's centre [m]
/// @param reflect coordinates that run against the slider's own
std::vector<double> mean_gap(const Slider& slider, const std::vector<double>& lines_x,
                             const std::vector<double>& lines_y,
                             const std::array<bool, 2>& reflect);
/// Means of the gap of a slider in a pose, over the cells of a tensor grid, x fastest [m].
std::vector<double> mean_gap(const Slider& slider, const shapes::Pose& pose,
                             const std::vector<double>& lines_x, const std::vector<double>& lines_y,
                             const std::array<bool, 2>& reflect);

} // namespace ionskin::mechanics
