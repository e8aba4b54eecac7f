// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/history/core_history.hpp"
#include "ionskin/history/line_operators.hpp"

#include <vector>

namespace ionskin::history {

/// Projects a strain channel onto another grid: averages it over the columns of another x-y grid by
/// exact overlap of cells, and takes it to other z levels by an operator. With `hat_averages` the
/// operator conserves the integral and the first moment over z; with `linear_interpolation` it
/// keeps the values at the walls of the core.
class StrainProjection {
public:
  /// @param history strain history; must outlive the projection
  /// @param channel channel of `history`
  /// @param x_edges,y_edges edges of the target columns, measured from the skin's corner [m]
  /// @param along_z operator from the z nodes of the history to the target levels
  StrainProjection(const CoreHistory& history, const HistoryChannel& channel,
                   std::vector<double> x_edges, std::vector<double> y_edges, LineOperator along_z);

  /// Evaluates the channel at an instant, averaged over each target column.
  /// @param time [s]; values are linear in time between samples
  /// @param field receives the values in the unit of the channel, [z][y][x] with x fastest; resized
  void evaluate(double time, std::vector<double>& field) const;

private:
  const CoreHistory& history_;
  const HistoryChannel& channel_;
  std::vector<double> x_edges_, y_edges_;
  LineOperator along_z_;
  mutable StrainField source_, after_y_, after_x_; ///< scratch memory, so that no call allocates
};

} // namespace ionskin::history
