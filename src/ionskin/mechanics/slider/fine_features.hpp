// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace ionskin::mechanics {

/// The cell in which an underside departs most from a plane, of those that it reaches.
struct FineFeatures {
  double departure = 0;              ///< rms about the plane that fits best [m]
  std::array<double, 2> cell_size{}; ///< [m]
};

/// Departure of a slider's underside from planes within the cells of a contact.
/// @param lines_x,lines_y cell edges from the slider's centre [m]
/// @param depth below which the underside reaches, from its lowest point [m]
FineFeatures fine_features(const Slider& slider, const std::vector<double>& lines_x,
                           const std::vector<double>& lines_y, double depth);

/// A sentence where a height map has features that the contact's cells, which feel its mean over
/// each, do not resolve; none for other undersides, whose shape has one scale.
/// @param depth deepest indentation [m]
std::optional<std::string> warn_of_fine_features(const Slider& slider,
                                                 const std::vector<double>& lines_x,
                                                 const std::vector<double>& lines_y, double depth);

} // namespace ionskin::mechanics
