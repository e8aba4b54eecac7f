// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

namespace ionskin::history {

// One-dimensional operators along a line of a grid. Tensor products of them transfer a field from
// the strain points of Study 1 (mechanics) to the cells of Study 2 (ion transport), and conserve
// its integral and first moment.

/// Linear operator along one direction of a grid, stored as sparse rows: row i has the weights of
/// the source entries first[i], first[i] + 1, ...
struct LineOperator {
  std::size_t sources = 0; ///< number of source entries
  std::vector<std::size_t> first;
  std::vector<std::vector<double>> weights;
  std::size_t rows() const { return first.size(); }
};

/// L2 projection onto continuous piecewise linear functions, from values at the two Gauss points of
/// each interval. It conserves the integral and the first moment.
/// @param lines ends of the n intervals, ascending, [n + 1]
/// @returns operator with n + 1 rows, one for each node, and 2 n sources, the Gauss points
LineOperator linear_projection(const std::vector<double>& lines);

/// L2 projection from the Gauss points of n intervals, as `linear_projection`, onto twice as many
/// linear pieces: nodes are the ends of the intervals and their middles. The finer nodes keep more
/// of a steep change at the outer ends.
/// @returns operator with 2 n + 1 rows (nodes) and 2 n sources (Gauss points)
LineOperator halved_projection(const std::vector<double>& lines);
/// L2 projection onto continuous piecewise linear functions, as `linear_projection`, but from the
/// means over both halves of each interval.
/// @returns operator with n + 1 rows (nodes) and 2 n sources (halves)
LineOperator half_means_projection(const std::vector<double>& lines);
/// Halves each interval.
/// @returns the ends of the n intervals and their middles, ascending, [2 n + 1]
std::vector<double> halved(const std::vector<double>& lines);

/// Averages of a continuous piecewise linear function over cells, each over the part of the cell
/// that lies within the lines. A cell outside of the lines takes the value at the nearer end, so
/// that the average over a cell that crosses an end is a smooth function of the cell's position.
/// @returns operator with a row for each cell and a source for each node in `lines`
LineOperator cell_averages(const std::vector<double>& lines, const std::vector<double>& cell_edges);

/// Averages of a piecewise constant function over target cells by exact overlap. Weights are
/// relative to the full length of the target cell, so that parts outside of all source cells count
/// as 0.
/// @returns operator with a row for each target cell and a source for each source cell
LineOperator overlap_averages(const std::vector<double>& source_edges,
                              const std::vector<double>& target_edges);

/// Averages over target cells of a function that is linear in each interval and is given by its
/// means over both halves of each interval.
/// @param lines ends of the intervals, ascending
/// @param target_edges edges of the target cells, within `lines`
/// @returns operator with a row for each target cell and two sources for each interval
LineOperator half_means_averages(const std::vector<double>& lines,
                                 const std::vector<double>& target_edges);

/// Averages of a continuous piecewise linear function, weighted with the hat functions of target
/// nodes. Integral and first moment are conserved, because the hat functions sum to one and
/// reproduce linear functions. Source and target nodes span the same interval.
/// @returns operator with a row for each target node and a source for each source node
LineOperator hat_averages(const std::vector<double>& source_nodes,
                          const std::vector<double>& target_nodes);

/// Values of a continuous piecewise linear function at target nodes. Target nodes beyond the source
/// nodes take the value at the nearer end.
/// @returns operator with a row for each target node and a source for each source node
LineOperator linear_interpolation(const std::vector<double>& source_nodes,
                                  const std::vector<double>& target_nodes);

/// Product of two operators: applies `first`, then `second` to the result.
LineOperator compose(const LineOperator& second, const LineOperator& first);

/// Applies an operator along the middle index of a field.
/// @param outer,inner numbers of values of the first and the last index
/// @param field [outer][sources][inner]
/// @param result receives [outer][rows][inner]; resized; not `field`
void apply_along(const LineOperator& line, std::size_t outer, std::size_t inner,
                 const std::vector<double>& field, std::vector<double>& result);

} // namespace ionskin::history
