// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/history/core_history.hpp"
#include "ionskin/history/line_operators.hpp"

#include <vector>

namespace ionskin::history {

/// Averages a channel over the columns of another x-y grid by exact overlap of cells, and takes it
/// to other levels by an operator along z: `hat_averages` conserve the integral and the first
/// moment, `linear_interpolation` keeps the values at the walls.
class StrainProjection {
public:
  /// @param history must outlive the projection
  /// @param channel of the history
  /// @param x_edges, y_edges column edges in the skin's frame [m]
  /// @param along_z from the history's z nodes to the levels wanted
  StrainProjection(const CoreHistory& history, const HistoryChannel& channel,
                   std::vector<double> x_edges, std::vector<double> y_edges, LineOperator along_z);

  /// The channel averaged over each column, [z][y][x] with x fastest. `field` is resized.
  /// @param time [s]; between samples linear
  void evaluate(double time, std::vector<double>& field) const;

private:
  const CoreHistory& history_;
  const HistoryChannel& channel_;
  std::vector<double> x_edges_, y_edges_;
  LineOperator along_z_;
  mutable StrainField source_, after_y_, after_x_; ///< scratch, so that no step allocates
};

} // namespace ionskin::history
