// SPDX-License-Identifier: Apache-2.0
#include "ionskin/handover/strain_grid.hpp"

#include "ionskin/case/coupling.hpp"
#include "ionskin/history/line_operators.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace ionskin::handover {
namespace {

constexpr double outer_cell_growth = 1.4;

/// Makes cell edges outward from 0 to `extent`, with sizes that grow from `first` up to `limit`.
std::vector<double> graded_cells(double first, double extent, double limit) {
  std::vector<double> edges;
  double size = first;
  double at = 0;
  while (at + 1.5 * size < extent) {
    at += size;
    edges.push_back(at);
    size = std::min(size * outer_cell_growth, limit);
  }
  edges.push_back(extent);
  return edges;
}

/// Makes cell edges that move with the slider, in a direction in which it moves: the mesh lines of
/// the footprint, and outside them graded cells that cover the core from every position of the
/// slider.
std::vector<double> riding_edges(const std::vector<double>& footprint, double low, double high,
                                 double limit) {
  std::vector<double> edges;
  const double first_low = footprint[1] - footprint[0];
  for (const double distance : graded_cells(first_low, footprint.front() - low, limit)) {
    edges.push_back(footprint.front() - distance);
  }
  std::reverse(edges.begin(), edges.end());
  edges.insert(edges.end(), footprint.begin(), footprint.end());
  const double first_high = footprint.back() - footprint[footprint.size() - 2];
  for (const double distance : graded_cells(first_high, high - footprint.back(), limit)) {
    edges.push_back(footprint.back() + distance);
  }
  return edges;
}

std::vector<double> relative(const std::vector<double>& lines, std::size_t begin, std::size_t end,
                             double centre) {
  std::vector<double> result(lines.begin() + static_cast<std::ptrdiff_t>(begin),
                             lines.begin() + static_cast<std::ptrdiff_t>(end));
  for (double& line : result) {
    line -= centre;
  }
  return result;
}

/// Makes the cell edges along one direction, from the slider's centre; for a half model only its
/// half.
std::vector<double> direction_edges(const std::vector<double>& lines,
                                    const std::array<std::size_t, 2>& footprint, double extent,
                                    double start, double lowest, double highest, double limit) {
  if (lowest == highest) {
    return relative(lines, 0, lines.size(), start);
  }
  const auto inner = relative(lines, footprint[0], footprint[1] + 1, start);
  return riding_edges(inner, -highest, extent - lowest, limit);
}

/// Continues the edges of the half y <= 0 by reflection to the whole width.
std::vector<double> reflected_edges(std::vector<double> half) {
  for (std::size_t i = half.size() - 1; i-- > 0;) {
    half.push_back(-half[i]);
  }
  return half;
}

} // namespace

// Outside the footprint, strain decays over the thickness of the skin, and coarser cells change the
// current by 0.1 %. Where the thickness is small against the length, cells of an 80th of the length
// lie only where the strain has already decayed.
double outer_cell_limit(const Skin& skin) {
  // The thickness is rounded to a picometre, so that rounding in reading and adding thicknesses
  // does not show.
  const double thickness = std::round(skin.thickness() * 1e12) / 1e12;
  return std::max(thickness, skin.length / 80);
}

std::vector<double> core_lines(const mesh::SkinMesh& mesh, const mesh::MeshLines& lines) {
  const auto rows = mesh.core_z();
  return relative(lines.z, rows[0], rows[1] + 1, lines.z[rows[0]]);
}

CoreGrid core_grid(const Case& input, const mesh::SkinMesh& mesh, const MotionBox& box) {
  const auto start_lines = mesh.lines(box.low);
  const double limit = outer_cell_limit(input.skin);
  return {direction_edges(start_lines.x, mesh.footprint_x(), input.skin.length, box.low[0],
                          box.low[0], box.high[0], limit),
          direction_edges(start_lines.y, mesh.footprint_y(), input.skin.width, box.low[1],
                          box.low[1], box.high[1], limit),
          core_lines(mesh, start_lines)};
}

history::StrainGrid strain_grid(const Case& input, const mesh::SkinMesh& mesh,
                                const CoreGrid& core) {
  return {core.x_edges, mesh.half_model() ? reflected_edges(core.y_edges) : core.y_edges,
          moves_water(input) ? history::halved(core.z_lines) : core.z_lines};
}

} // namespace ionskin::handover
