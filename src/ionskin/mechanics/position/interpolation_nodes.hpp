// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace ionskin::mechanics {

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
/// Across narrow shared positions two are tried.
std::size_t expected_node_count(const Case& input, const std::array<double, 2>& from,
                                const std::array<double, 2>& to);

} // namespace ionskin::mechanics
