// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"

#include <vector>

namespace ionskin::results {

/// A slider's underside for drawings, denser towards its ends, where a rounded edge is steep.
struct SliderSurface {
  std::vector<double> x, y;   ///< from the slider's centre [m]
  std::vector<double> height; ///< above its lowest point, [y][x], x fastest [m]
};

/// Heights of a slider's underside for drawings.
/// @param x,y further places, as far as they lie within the plan [m]
SliderSurface slider_surface(const Slider& slider, const std::vector<double>& x = {},
                             const std::vector<double>& y = {});

} // namespace ionskin::results
