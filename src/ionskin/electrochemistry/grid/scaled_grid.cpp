// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/grid/scaled_grid.hpp"

#include <algorithm>
#include <cmath>

namespace ionskin::electrochemistry {
namespace {

double lateral_coupling(const std::vector<double>& edges, double debye_length) {
  const auto columns = edges.size() - 1;
  if (columns == 1) {
    return 0.0;
  }
  const double width =
      (edges.back() - edges.front()) / (static_cast<double>(columns) * debye_length);
  return 1.0 / (width * width);
}

/// Coefficient e of `charge_weights` for an interval.
/// @param wall_distance distance of the middle of the interval from the nearer wall [Debye lengths]
double charge_exchange(double spacing, double wall_distance) {
  return 0.25 * spacing / (1.0 + std::pow(wall_distance / 6.0, 8));
}

/// Multiplies the area of the intervals within `interface_depth` of either wall by `area_ratio`.
void enlarge_interfaces(double area_ratio, ScaledGrid& grid) {
  const double whole = grid.thickness;
  grid.height.assign(grid.levels, 0.0);
  double depth = 0.0;
  grid.thickness = grid.volume = 0.0;
  std::vector<double> passed{0.0};
  for (std::size_t k = 0; k + 1 < grid.levels; ++k) {
    const double spacing = grid.spacing[k], middle = depth + 0.5 * spacing;
    const double area = std::min(middle, whole - middle) < interface_depth ? area_ratio : 1.0;
    depth += spacing;
    grid.height[k] += 0.5 * spacing * area;
    grid.height[k + 1] += 0.5 * spacing * area;
    grid.volume += spacing * area;
    grid.spacing[k] /= area;
    grid.charge_exchange[k] *= area;
    grid.thickness += grid.spacing[k];
    passed.push_back(grid.thickness);
  }
  for (std::size_t k = 0; k < grid.levels; ++k) {
    grid.position[k] = passed[k] / grid.thickness;
  }
}

} // namespace

ChargeWeights charge_weights(const ScaledGrid& grid, std::size_t level) {
  const double below = level > 0 ? grid.charge_exchange[level - 1] : 0.0;
  const double above = level + 1 < grid.levels ? grid.charge_exchange[level] : 0.0;
  return {below, grid.height[level] - below - above, above};
}

ScaledGrid scale_grid(const TransportGrid& grid, double debye_length, double area_ratio) {
  ScaledGrid scaled;
  scaled.columns_x = grid.x_edges.size() - 1;
  scaled.columns_y = grid.y_edges.size() - 1;
  scaled.levels = grid.z_nodes.size();
  scaled.unit = debye_length;
  scaled.volume = scaled.thickness = grid.z_nodes.back() / debye_length;
  scaled.coupling_x = lateral_coupling(grid.x_edges, debye_length);
  scaled.coupling_y = lateral_coupling(grid.y_edges, debye_length);
  scaled.height.assign(scaled.levels, 0.0);
  for (std::size_t k = 0; k + 1 < scaled.levels; ++k) {
    const double spacing = (grid.z_nodes[k + 1] - grid.z_nodes[k]) / debye_length;
    scaled.spacing.push_back(spacing);
    const double middle = 0.5 * (grid.z_nodes[k] + grid.z_nodes[k + 1]) / debye_length;
    scaled.charge_exchange.push_back(
        charge_exchange(spacing, std::min(middle, scaled.thickness - middle)));
    scaled.height[k] += 0.5 * spacing;
    scaled.height[k + 1] += 0.5 * spacing;
  }
  for (const double z : grid.z_nodes) {
    scaled.position.push_back(z / grid.z_nodes.back());
  }
  if (area_ratio != 1.0) {
    enlarge_interfaces(area_ratio, scaled);
  }
  return scaled;
}

} // namespace ionskin::electrochemistry
