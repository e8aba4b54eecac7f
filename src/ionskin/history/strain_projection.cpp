// SPDX-License-Identifier: Apache-2.0
#include "ionskin/history/strain_projection.hpp"

#include <utility>

namespace ionskin::history {

StrainProjection::StrainProjection(const CoreHistory& history, const HistoryChannel& channel,
                                   std::vector<double> x_edges, std::vector<double> y_edges,
                                   LineOperator along_z)
    : history_(history), channel_(channel), x_edges_(std::move(x_edges)),
      y_edges_(std::move(y_edges)), along_z_(std::move(along_z)) {}

void StrainProjection::evaluate(double time, std::vector<double>& field) const {
  const TimeBracket at = bracket(history_, time);
  interpolate_field(history_, channel_, at, source_);
  const LineOperator along_x = overlap_averages(skin_x_edges(history_, at), x_edges_);
  const LineOperator along_y = overlap_averages(skin_y_edges(history_, at), y_edges_);
  const std::size_t levels = history_.grid.z_nodes.size();
  // The projection along y comes first: for a field symmetric about mid-width it leaves half the
  // rows to the other projections.
  apply_along(along_y, levels, history_.grid.columns_x(), source_, after_y_);
  apply_along(along_x, levels * along_y.rows(), 1, after_y_, after_x_);
  apply_along(along_z_, 1, along_x.rows() * along_y.rows(), after_x_, field);
}

} // namespace ionskin::history
