// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"

#include <array>
#include <vector>

namespace ionskin::mechanics {

inline constexpr double unreachable_gap =
    1.0; ///< outside the slider's plan, where nothing touches [m]

/// The face of a slider that presses on the skin.
class Underside {
public:
  explicit Underside(const Slider& slider);
  /// Height above its lowest point at a place from the slider's centre [m].
  double gap(double x, double y) const;

private:
  double profile_gap(double x, double y) const;

  const Slider& slider_;
  double lowest_ = 0;
};

/// Means of the gap over the cells of a tensor grid, x fastest [m].
/// @param lines_x,lines_y cell edges from the slider's centre [m]
/// @param reflect coordinates that run against the slider's own
std::vector<double> mean_gap(const Slider& slider, const std::vector<double>& lines_x,
                             const std::vector<double>& lines_y,
                             const std::array<bool, 2>& reflect);

} // namespace ionskin::mechanics
