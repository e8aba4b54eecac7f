// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"

#include <cstddef>
#include <vector>

namespace ionskin::mechanics {

/// At most so many interpolation nodes.
inline constexpr std::size_t most_interpolation_nodes = 16;

/// A coordinate along one axis of the skin in which what lies under the slider is close to a
/// polynomial: the logarithm of the ratio of the distances to two ends [1]. Along a slide over two
/// fifths of the skin the error of polynomials falls by 0.15 with each node, by 0.24 in the place.
struct EndCoordinate {
  double first = 0, last = 1; ///< ends [m]

  double at(double place) const;
  double place(double coordinate) const; ///< [m]
};

/// Between the ends of the skin.
/// @param low,high least and largest place of the slider's centre [m]
/// @param size of the skin along the axis [m]
EndCoordinate end_coordinate(double low, double high, double size);

/// `count` places between `low` and `high`, ascending, both included [m]. Those of a smaller count
/// are among those of a larger one; in pairs, of a smaller even count.
/// @param count 2 to most_interpolation_nodes + 1
/// @param in_pairs whether the places mirror each other in the skin's middle: so they share
/// factorisations
std::vector<double> interpolation_nodes(const EndCoordinate& coordinate, double low, double high,
                                        std::size_t count, bool in_pairs);

/// Whether the places between two mirror each other in the skin's middle.
bool mirrored_places(double low, double high, double size);

/// By which the values at the nodes give the value of their polynomial at a point (Lagrange).
std::vector<double> interpolation_weights(const std::vector<double>& nodes, double at);

/// How many nodes to begin with, and how many are expected to keep the tolerance.
struct ExpectedNodes {
  std::size_t first = 0, all = 0;
};

/// Of places between two along an axis; even where they come in pairs. A short way needs fewer,
/// since the error of interpolation falls with the power of its length that is the count. Across
/// narrow shared positions two are tried.
/// @param axis 0 for x, 1 for y
ExpectedNodes expected_nodes(const Case& input, std::size_t axis, double low, double high);

} // namespace ionskin::mechanics
