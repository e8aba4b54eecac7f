// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

namespace ionskin::history {

// One-dimensional operators along a mesh line. Tensor products of them carry a field from the
// places of the mechanics to the cells of the ion transport without losing integral or first
// moment.

/// Sparse rows of weights: row i holds weights of source entries first[i], first[i] + 1, ...
struct LineOperator {
  std::size_t sources = 0;
  std::vector<std::size_t> first;
  std::vector<std::vector<double>> weights;
  std::size_t rows() const { return first.size(); }
};

/// L2 projection of values at the two Gauss points of each interval on continuous piecewise-linear
/// functions. Integral and first moment are conserved.
/// @param lines interval ends, ascending [n + 1]
/// Rows: n + 1 nodes; sources: 2 n points.
LineOperator linear_projection(const std::vector<double>& lines);

/// L2 projection as `linear_projection` makes it, on twice the nodes: the ends of the intervals and
/// their middles. It keeps more of a change at the outer ends.
/// Rows: 2 n + 1 nodes; sources: 2 n points.
LineOperator halved_projection(const std::vector<double>& lines);
/// L2 projection of the means over both halves of each interval, otherwise as `linear_projection`.
LineOperator half_means_projection(const std::vector<double>& lines);
/// Ends of the intervals and their middles.
std::vector<double> halved(const std::vector<double>& lines);

/// Averages of a continuous piecewise-linear function over cells, each over its part within the
/// lines. Cells outside take the value at the nearer end, so that a cell that crosses the end stays
/// smooth in its position. Rows: cells; sources: line nodes.
LineOperator cell_averages(const std::vector<double>& lines, const std::vector<double>& cell_edges);

/// Averages of a piecewise-constant function over target cells by exact overlap, relative to the
/// target cell's length. Rows: target cells; sources: source cells.
LineOperator overlap_averages(const std::vector<double>& source_edges,
                              const std::vector<double>& target_edges);

/// Averages over target cells of the function that is linear in each interval and has these means
/// over its halves. Rows: target cells, within the intervals; sources: two halves of each.
LineOperator half_means_averages(const std::vector<double>& lines,
                                 const std::vector<double>& target_edges);

/// Averages of a continuous piecewise-linear function weighted with the hat functions of target
/// nodes. The hats sum to one and reproduce linear functions, so integral and first moment are
/// conserved. Rows: target nodes; sources: source nodes. Both span the same interval.
LineOperator hat_averages(const std::vector<double>& source_nodes,
                          const std::vector<double>& target_nodes);

/// Values of a continuous piecewise-linear function at target nodes within the span of its own.
/// Rows: target nodes; sources: source nodes.
LineOperator linear_interpolation(const std::vector<double>& source_nodes,
                                  const std::vector<double>& target_nodes);

/// Product of two operators: `second` applied to the result of `first`.
LineOperator compose(const LineOperator& second, const LineOperator& first);

/// Applies an operator along the middle index of a field [outer][sources][inner] into
/// [outer][rows][inner]; `result` is resized.
void apply_along(const LineOperator& line, std::size_t outer, std::size_t inner,
                 const std::vector<double>& field, std::vector<double>& result);

} // namespace ionskin::history
