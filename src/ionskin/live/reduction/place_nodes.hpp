// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/case/slider_motion.hpp"

#include <vector>

namespace ionskin::live {

/// Grid of positions of the slider's centre at which the reduced-order skin is computed from the
/// full model; it interpolates by polynomials in between [m].
struct PlaceNodes {
  std::vector<double> x, y; ///< ascending; one line where the slider does not move
};

/// Chooses the Chebyshev points of a rectangle of positions, borders included. The skin's response
/// is smooth in the slider's position, so that the relative error of the polynomials is 0.24 to the
/// power of the number of points.
PlaceNodes place_nodes(const Skin& skin, const MotionBox& box);

} // namespace ionskin::live
