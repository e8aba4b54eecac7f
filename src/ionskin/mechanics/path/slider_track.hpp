// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace ionskin::mechanics {

/// The straight path of the slider's centre in the first slide of a cycle; positions are arc
/// lengths from its start.
struct SliderTrack {
  std::array<double, 2> start{};     ///< [m]
  std::array<double, 2> direction{}; ///< unit vector
  double stroke = 0;                 ///< [m]

  explicit SliderTrack(const Case& input);
  std::array<double, 2> centre(double arc_length) const;
};

/// A slider position up to reflection of the rectangular skin: positions that are mirror images of
/// each other share one, and so share a factorisation.
struct CanonicalPosition {
  std::array<double, 2> centre{}; ///< x <= length / 2 and y <= width / 2 [m]
  std::array<bool, 2> reflect{};  ///< which coordinates were reflected to get there

  /// A horizontal vector as it appears in the canonical position, and back.
  std::array<double, 2> reflected(const std::array<double, 2>& vector) const;
};

CanonicalPosition canonical_position(const Skin& skin, const std::array<double, 2>& centre);

} // namespace ionskin::mechanics
