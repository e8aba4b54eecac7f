// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/case/slider_motion.hpp"

#include <vector>

namespace ionskin::live {

/// Lines of places of the slider's centre at which a live skin knows the full one; it is a
/// polynomial of the place in between [m].
struct PlaceNodes {
  std::vector<double> x, y; ///< ascending; one where the slider stays
};

/// Chebyshev points of a rectangle of places, its borders among them: the skin's answer under the
/// slider is smooth in its place, and their polynomial errs by a part of 0.24 to the power of their
/// number.
PlaceNodes place_nodes(const Skin& skin, const MotionBox& box);

} // namespace ionskin::live
