// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"

#include <vector>

namespace ionskin::results {

/// Sampled heights of a slider's underside, for drawings. Samples are denser towards its ends,
/// where a rounded edge is steep.
struct SliderSurface {
  std::vector<double> x, y;   ///< positions of the samples from the slider's centre [m]
  std::vector<double> height; ///< height above the lowest point, [y][x] with x fastest [m]
};

/// Samples the underside of a slider over its plan (its outline seen from above).
/// @param x,y positions of further samples, from the slider's centre [m]; those outside the plan
///   are ignored
SliderSurface slider_surface(const Slider& slider, const std::vector<double>& x = {},
                             const std::vector<double>& y = {});

} // namespace ionskin::results
