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

/// At most so many interpolation nodes.
inline constexpr std::size_t most_interpolation_nodes = 16;

/// `count` nodes on [0, stroke], ascending, ends included, symmetric to rounding: mirrored pairs,
/// so that they share factorisations, and the middle where the count is odd. The pairs of a smaller
/// count are among those of a larger one.
/// @param count 2 to most_interpolation_nodes + 1
std::vector<double> interpolation_nodes(double stroke, std::size_t count);

/// By which the values at the nodes give the value of their polynomial at a point (Lagrange).
std::vector<double> interpolation_weights(const std::vector<double>& nodes, double at);

/// Even number of nodes that a straight piece of a track is expected to need. A short piece needs
/// fewer, since the error of interpolation falls with the power of its length that is the count.
std::size_t expected_node_count(const Case& input, const std::array<double, 2>& from,
                                const std::array<double, 2>& to);

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
