// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/circuit/electrode_segments.hpp"

#include <algorithm>
#include <numeric>

namespace ionskin::electrochemistry {
namespace {

/// Shares below this are rounding errors of edges that coincide.
constexpr double share_rounding = 1e-9;

/// Fraction of each cell of a line that lies between `lower` and `upper`.
std::vector<double> covered(const std::vector<double>& edges, double lower, double upper) {
  std::vector<double> fraction(edges.size() - 1);
  for (std::size_t i = 0; i < fraction.size(); ++i) {
    const double length = edges[i + 1] - edges[i];
    const double inside = std::min(edges[i + 1], upper) - std::max(edges[i], lower);
    fraction[i] = std::clamp(inside / length, 0.0, 1.0);
  }
  return fraction;
}

std::vector<double> covered(const Taxel& taxel, const TransportGrid& grid) {
  const std::vector<double> along_x = covered(grid.x_edges, taxel.lower[0], taxel.upper[0]);
  const std::vector<double> along_y = covered(grid.y_edges, taxel.lower[1], taxel.upper[1]);
  std::vector<double> share;
  share.reserve(along_x.size() * along_y.size());
  for (const double y : along_y) {
    for (const double x : along_x) {
      share.push_back(y * x);
    }
  }
  return share;
}

} // namespace

std::vector<double> ElectrodeSegments::charges(std::span<const double> column_charge) const {
  std::vector<double> result;
  result.reserve(share.size());
  for (const std::vector<double>& weights : share) {
    // Sums in extended precision: a current divides the rounding of the sum by the length of a
    // step.
    result.push_back(static_cast<double>(
        std::inner_product(weights.begin(), weights.end(), column_charge.begin(), 0.0L)));
  }
  return result;
}

ElectrodeSegments make_electrode_segments(const std::vector<Taxel>& taxels,
                                          const TransportGrid& grid) {
  ElectrodeSegments segments;
  if (taxels.empty()) {
    return segments;
  }
  std::vector<double> rest((grid.x_edges.size() - 1) * (grid.y_edges.size() - 1), 1.0);
  for (const Taxel& taxel : taxels) {
    segments.names.push_back(taxel.name);
    segments.share.push_back(covered(taxel, grid));
    std::ranges::transform(rest, segments.share.back(), rest.begin(), std::minus<>());
  }
  if (std::ranges::any_of(rest, [](double share) { return share > share_rounding; })) {
    segments.names.emplace_back("rest");
    segments.share.push_back(std::move(rest));
  }
  return segments;
}

} // namespace ionskin::electrochemistry
