// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/strain/line_operators.hpp"
#include "ionskin/strain/strain_history.hpp"

#include <vector>

namespace ionskin::strain {

/// Averages a history over the columns of another x-y grid and projects it on other z nodes,
/// conserving the integral and the first moment: exact overlap of cells in x and y, hat functions
/// in z.
class StrainProjection {
public:
  /// @param history must outlive the projection
  /// @param x_edges, y_edges column edges in the skin's frame [m]
  /// @param z_nodes nodes from 0 to the core thickness [m]
  StrainProjection(const StrainHistory& history, std::vector<double> x_edges,
                   std::vector<double> y_edges, const std::vector<double>& z_nodes);

  /// Shear per control volume, [z][y][x] with x fastest. The control volume of a z node is the
  /// integral of its hat function. `field` is resized.
  /// @param time [s]; between samples linear
  void evaluate(double time, std::vector<double>& field) const;

private:
  const StrainHistory& history_;
  std::vector<double> x_edges_, y_edges_;
  LineOperator along_z_;
  mutable StrainField source_, after_y_, after_x_; ///< scratch, so that no step allocates
};

} // namespace ionskin::strain
