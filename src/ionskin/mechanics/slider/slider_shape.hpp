// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"

#include <array>
#include <memory>
#include <vector>

namespace ionskin::mechanics {

/// Underside of a slider in one pose. The slider must outlive this object.
class Underside {
public:
  Underside(const Slider& slider, const shapes::Pose& pose);
  /// Height of the underside above its lowest point, at x and y from the slider's centre [m];
  /// `shapes::unreachable_gap` beyond its plan.
  double gap(double x, double y) const;

  /// Mean height of the underside over a cell, above the lowest point of the underside [m]. Under a
  /// slider with a yaw, a cell that lies by more than half beyond the plan does not belong to the
  /// underside, and of other cells only the part within the plan counts.
  /// @param low,high opposite corners of the cell, from the slider's centre [m]
  /// @param reflect true, along x or y, to take the underside at the mirrored coordinate
  double mean_gap(const std::array<double, 2>& low, const std::array<double, 2>& high,
                  const std::array<bool, 2>& reflect) const;

private:
  shapes::Plan plan_;
  std::unique_ptr<const shapes::Shape> shape_;
  bool flat_;
  bool turned_; ///< true if a yaw turns its edges out of the directions of the cells
  double lowest_;
};

/// Mean height of a slider's underside over each cell of a tensor grid, above its lowest point, in
/// the pose of the slider [m]; x fastest.
/// @param lines_x,lines_y cell edges from the slider's centre [m]
/// @param reflect true, along x or y, to take the underside at the mirrored coordinate
std::vector<double> mean_gap(const Slider& slider, const std::vector<double>& lines_x,
                             const std::vector<double>& lines_y,
                             const std::array<bool, 2>& reflect);
/// Mean height of a slider's underside over each cell of a tensor grid, above its lowest point, in
/// a given pose [m]; x fastest. Parameters are those of the overload without a pose.
std::vector<double> mean_gap(const Slider& slider, const shapes::Pose& pose,
                             const std::vector<double>& lines_x, const std::vector<double>& lines_y,
                             const std::array<bool, 2>& reflect);

} // namespace ionskin::mechanics
