// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mesh/skin_mesh.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/case/slider_motion.hpp"
#include "ionskin/mesh/grading.hpp"
#include "ionskin/mesh/mesh_resolution.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace ionskin::mesh {
namespace {

/// Outer elements thinner than this fraction of the edge element are refused.
constexpr double smallest_margin = 0.05;

bool covers_width(const Case& input) {
  return input.skin.sides == SideCondition::symmetry && input.slider.size[1] >= input.skin.width;
}

bool moves_on_symmetry_plane(const Case& input) {
  const MotionBox box = motion_box(input.motion, input.slider);
  const double offset = std::abs(box.low[1] - input.skin.width / 2);
  return box.low[1] == box.high[1] && (covers_width(input) || offset <= 1e-12 * input.skin.width);
}

std::vector<double> footprint_lines(double size, const MeshResolution& resolution, bool half) {
  const std::vector<double> outwards = graded_line(
      size / 2, resolution.edge_size, resolution.footprint_growth, resolution.footprint_largest);
  std::vector<double> lines{-size / 2};
  append(lines, outwards);
  lines.back() = 0;
  if (!half) {
    for (std::size_t i = outwards.size() - 1; i-- > 0;) {
      lines.push_back(size / 2 - outwards[i]);
    }
  }
  return lines;
}

} // namespace

std::vector<double> SkinMesh::Axis::lines(double centre, double skin_size) const {
  const double middle = centred ? skin_size / 2 : centre;
  std::vector<double> result{0.0};
  const double before = std::max(0.0, middle + inner.front());
  if (outer > 0) {
    result = reversed(geometric_line(before, outer_first, outer));
  }
  for (std::size_t i = 1; i < inner.size(); ++i) {
    result.push_back(middle + inner[i]);
  }
  if (outer > 0 && !half) {
    append(result, geometric_line(skin_size - middle - inner.back(), outer_first, outer));
  }
  result.back() = extent;
  return result;
}

SkinMesh::Axis SkinMesh::make_axis(const Case& input, std::size_t direction) const {
  const MeshResolution resolution = mesh_resolution(input);
  const double skin_size = direction == 0 ? skin_.length : skin_.width;
  Axis axis;
  axis.half = direction == 1 && half_model_;
  axis.extent = axis.half ? skin_size / 2 : skin_size;
  axis.centred = axis.half;
  if (direction == 1 && covers_width(input)) {
    // Plane strain: nothing varies along y.
    axis.centred = true;
    axis.inner = {-skin_size / 2, axis.half ? 0.0 : skin_size / 2};
    return axis;
  }
  const double size = input.slider.size[direction];
  axis.inner = footprint_lines(size, resolution, axis.half);
  const MotionBox box = motion_box(input.motion, input.slider);
  const double low = box.low[direction], high = box.high[direction];
  const double shortest = std::min(low, skin_size - high) - size / 2;
  const double longest = std::max(high, skin_size - low) - size / 2;
  if (longest <= 1e-9 * skin_size) {
    return axis; // as large as the skin along this direction
  }
  if (shortest < smallest_margin * resolution.edge_size) {
    throw UserError(fmt::format("the slider comes within {:.3g} mm of the skin's edge along {} (at "
                                "least {:.3g} mm are needed "
                                "for the mesh): shorten motion.stroke or move slider.start",
                                std::max(0.0, shortest) * 1e3, direction == 0 ? "x" : "y",
                                smallest_margin * resolution.edge_size * 1e3));
  }
  const double way = box.high[direction] - box.low[direction];
  const double whole = std::hypot(box.high[0] - box.low[0], box.high[1] - box.low[1]);
  const bool main_direction = whole > 0 ? way > 0.5 * whole : direction == 0;
  const std::size_t minimum = main_direction ? resolution.outer_minimum : 2;
  axis.outer =
      std::max(minimum, geometric_count(longest, resolution.edge_size, resolution.outer_growth));
  axis.outer_first = std::min(resolution.edge_size, shortest / static_cast<double>(axis.outer));
  return axis;
}

SkinMesh::SkinMesh(const Case& input, MeshedPart part) : skin_(input.skin) {
  half_model_ = part == MeshedPart::half_if_symmetric && moves_on_symmetry_plane(input);
  x_ = make_axis(input, 0);
  y_ = make_axis(input, 1);

  const MeshResolution resolution = mesh_resolution(input);
  z_ = {0.0};
  for (std::size_t l = 0; l < skin_.layers.size(); ++l) {
    const Layer& layer = skin_.layers[l];
    const bool core = layer.role == LayerRole::core;
    const std::size_t count = core ? resolution.core_elements : resolution.electrode_elements;
    const std::size_t first = z_.size() - 1;
    append(z_, two_sided_line(layer.thickness, resolution.core_growth, count));
    layer_of_row_.resize(z_.size() - 1, l);
    if (core) {
      core_z_ = {first, first + count};
    }
  }
}

MeshLines SkinMesh::lines(const std::array<double, 2>& centre) const {
  return {x_.lines(centre[0], skin_.length), y_.lines(centre[1], skin_.width), z_};
}

std::array<std::size_t, 3> SkinMesh::elements() const {
  return {x_.elements(), y_.elements(), z_.size() - 1};
}

std::size_t SkinMesh::unknowns() const {
  const auto [nx, ny, nz] = elements();
  return 3 * (2 * nx + 1) * (2 * ny + 1) * (2 * nz + 1);
}

} // namespace ionskin::mesh
