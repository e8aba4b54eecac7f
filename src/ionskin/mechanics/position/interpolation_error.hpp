// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/mechanics/output/contact_solution.hpp"

#include <cstddef>
#include <memory>
#include <vector>

namespace ionskin::mechanics {

/// The strain in the core at an interpolation node of a line.
struct NodeStrain {
  double at = 0;                            ///< along the line, as of EndCoordinate
  std::shared_ptr<const CoreStrain> strain; ///< null: none
};

/// Norms of the Chebyshev coefficients of the polynomial through the nodes of a line, from order 0
/// on: of the strain in the core, over that of the largest node [1].
/// @param nodes at distinct places
std::vector<double> chebyshev_norms(const std::vector<NodeStrain>& nodes);

/// How far the polynomial through the nodes is from the strain between them.
struct InterpolationError {
  double estimate = 0; ///< of the strain in the core, over its largest norm on the line [1]
  double decay = 0;    ///< of the coefficients, from one order to the next [1]
};

/// From the decay of the Chebyshev coefficients, which is geometric for a smooth function: those
/// that the polynomial lacks go on as those that it has, and each errs by how far the polynomial
/// through the nodes is from its Chebyshev polynomial (Trefethen, Approximation Theory and
/// Approximation Practice, 2013, chapters 4 and 8).
/// @param nodes at least two, at distinct places
InterpolationError interpolation_error(const std::vector<NodeStrain>& nodes);

/// Largest interpolation error that is left where more nodes can mend it, along a line and over a
/// rectangle of places [1].
double interpolation_tolerance(Preset preset, bool over_rectangle);

/// Number of nodes that is expected to keep the tolerance: `count` itself when the error does, else
/// a larger one, at most `most_interpolation_nodes`.
/// @param in_pairs whether it is to be even
std::size_t wanted_node_count(std::size_t count, const InterpolationError& error, double tolerance,
                              bool in_pairs);

} // namespace ionskin::mechanics
