// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace ionskin::mechanics {

/// Contact cell in which a slider's underside departs most from a plane.
struct FineFeatures {
  double departure = 0; ///< rms from the plane of best fit [m]; 0 where nothing reaches the depth
  std::array<double, 2> cell_size{}; ///< along x and y [m]
};

/// Finds the contact cell in which a slider's underside departs most from a plane, of the cells
/// that the underside reaches.
/// @param lines_x,lines_y cell edges from the slider's centre [m]
/// @param depth only cells count in which the underside comes within this height of its lowest
///   point [m]
FineFeatures fine_features(const Slider& slider, const std::vector<double>& lines_x,
                           const std::vector<double>& lines_y, double depth);

/// Warning, as a text for the user, that a height map has features which the contact cells do not
/// resolve, because a cell feels the mean of the map only. Empty where the cells resolve the map,
/// and for undersides that are no height map, whose shape has a single scale.
/// @param lines_x,lines_y cell edges from the slider's centre [m]
/// @param depth deepest indentation [m]
std::optional<std::string> warn_of_fine_features(const Slider& slider,
                                                 const std::vector<double>& lines_x,
                                                 const std::vector<double>& lines_y, double depth);

} // namespace ionskin::mechanics
