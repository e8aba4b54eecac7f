// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mesh/skin_mesh.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/case/slider_motion.hpp"
#include "ionskin/mesh/grading.hpp"
#include "ionskin/mesh/mesh_resolution.hpp"
#include "ionskin/mesh/thickness_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace ionskin::mesh {
namespace {

/// Least size of outer elements, over the size of the edge element [1]; a mesh with smaller ones is
/// refused.
constexpr double smallest_margin = 0.05;
/// Width of the edge layer at a free face, and distance from the face up to which elements grow
/// from that layer on, in thicknesses of the skin [1]. Along the bonded base, the ends of the
/// layers and the corners between them, the strain varies within about half a thickness. The effect
/// of the free face fades over a few thicknesses. Ends far from the slider have the layer, too,
/// because friction pulls at electrodes over many thicknesses.
constexpr double face_layer = 0.5, face_zone = 3;

bool moves_on_symmetry_plane(const Case& input) {
  const MotionBox box = motion_box(input.motion, input.slider);
  const double offset = std::abs(box.low[1] - input.skin.width / 2);
  return box.low[1] == box.high[1] && input.slider.symmetric()[1] &&
         (covers_width(input) || offset <= 1e-12 * input.skin.width);
}

/// Lines from the edge of the footprint inwards to its centre [m]: a uniform rim, then growing
/// elements.
std::vector<double> lines_inwards(const Footprint& footprint, const MeshResolution& resolution,
                                  std::size_t direction) {
  const double half_size = footprint.half_size[direction], rim = footprint.rim[direction];
  const double size = resolution.edge_size[direction];
  const double largest = std::max(size, resolution.footprint_largest[direction]);
  if (footprint.sharp(direction)) {
    return graded_line(half_size, size, resolution.footprint_growth, largest,
                       resolution.edge_zone[direction]);
  }
  std::vector<double> lines = graded_line(std::min(rim, half_size), size, 1, size);
  if (!footprint.round(direction)) {
    append(lines, graded_line(half_size - rim, size, resolution.footprint_growth, largest));
  }
  return lines;
}

/// Lines from a free face of the skin inwards, from 0 [m].
/// @param most length that is available [m]
std::vector<double> face_lines(double thickness, double most, const MeshResolution& resolution) {
  std::vector<double> lines = growing_line(std::min(face_layer * thickness, most),
                                           resolution.outer_growth, resolution.face_elements);
  const double zone = std::min(face_zone * thickness, most);
  for (double size = lines.back() - lines[lines.size() - 2]; lines.back() < zone;) {
    size *= resolution.outer_growth;
    if (lines.back() + size > most) {
      break;
    }
    lines.push_back(lines.back() + size);
  }
  return lines;
}

std::vector<double> footprint_lines(const Footprint& footprint, const MeshResolution& resolution,
                                    std::size_t direction, bool half) {
  const double half_size = footprint.half_size[direction];
  const std::vector<double> inwards = lines_inwards(footprint, resolution, direction);
  std::vector<double> lines{-half_size};
  append(lines, inwards);
  lines.back() = 0;
  if (!half) {
    for (std::size_t i = inwards.size() - 1; i-- > 0;) {
      lines.push_back(half_size - inwards[i]);
    }
  }
  return lines;
}

} // namespace

std::vector<double> SkinMesh::Axis::outer_lines(double length) const {
  const std::size_t count = outer - (face.size() - 1);
  // A slider on a drive swings closer to the edge than the path that the lines were made for.
  const double least = face.back() + static_cast<double>(count) * outer_first;
  const double scale = length < least ? length / least : 1.0;
  std::vector<double> result =
      geometric_line(length - scale * face.back(), scale * outer_first, count);
  std::vector<double> outermost = reversed(face);
  for (double& line : outermost) {
    line *= scale;
  }
  append(result, outermost);
  return result;
}

std::vector<double> SkinMesh::Axis::lines(double centre, double skin_size) const {
  const double middle = centred ? skin_size / 2 : centre;
  std::vector<double> result{0.0};
  const double before = std::max(0.0, middle + inner.front());
  if (outer > 0) {
    result = reversed(outer_lines(before));
  }
  for (std::size_t i = 1; i < inner.size(); ++i) {
    result.push_back(middle + inner[i]);
  }
  if (outer > 0 && !half) {
    append(result, outer_lines(skin_size - middle - inner.back()));
  }
  result.back() = extent;
  return result;
}

SkinMesh::Axis SkinMesh::make_axis(const Case& input, std::size_t direction) const {
  const MeshResolution resolution = mesh_resolution(input, footprint_);
  const double edge_size = resolution.edge_size[direction];
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
  const double half_size = footprint_.half_size[direction];
  axis.inner = footprint_lines(footprint_, resolution, direction, axis.half);
  const MotionBox box = motion_box(input.motion, input.slider);
  const double low = box.low[direction], high = box.high[direction];
  const double shortest = std::min(low, skin_size - high) - half_size;
  const double longest = std::max(high, skin_size - low) - half_size;
  if (longest <= 1e-9 * skin_size) {
    return axis; // as large as the skin along this direction
  }
  if (shortest < smallest_margin * edge_size) {
    throw UserError(fmt::format("the slider comes within {:.3g} mm of the skin's edge along {} (at "
                                "least {:.3g} mm are needed "
                                "for the mesh): shorten motion.stroke or move slider.start",
                                std::max(0.0, shortest) * 1e3, direction == 0 ? "x" : "y",
                                smallest_margin * edge_size * 1e3));
  }
  const double way = box.high[direction] - box.low[direction];
  const double whole = std::hypot(box.high[0] - box.low[0], box.high[1] - box.low[1]);
  const bool main_direction = whole > 0 ? way > 0.5 * whole : direction == 0;
  const std::size_t minimum = main_direction ? resolution.outer_minimum : 2;
  const bool symmetry = direction == 1 && skin_.sides == SideCondition::symmetry;
  if (!symmetry) {
    axis.face = face_lines(skin_.thickness(), shortest / 2, resolution);
  }
  const double graded = longest - axis.face.back();
  const std::size_t count =
      std::max(minimum, geometric_count(graded, edge_size, resolution.outer_growth));
  axis.outer_first =
      std::min(edge_size, (shortest - axis.face.back()) / static_cast<double>(count));
  axis.outer = count + axis.face.size() - 1;
  return axis;
}

SkinMesh::SkinMesh(const Case& input, MeshedPart part)
    : SkinMesh(input, largest_footprint(input), part) {}

SkinMesh::SkinMesh(const Case& input, const Footprint& footprint, MeshedPart part)
    : skin_(input.skin), footprint_(footprint) {
  half_model_ = part == MeshedPart::half_if_symmetric && moves_on_symmetry_plane(input);
  x_ = make_axis(input, 0);
  y_ = make_axis(input, 1);
  ThicknessLines thickness = thickness_lines(skin_, footprint_, mesh_resolution(input, footprint_));
  z_ = std::move(thickness.z);
  layer_of_row_ = std::move(thickness.layer_of_row);
  const auto rows =
      std::equal_range(layer_of_row_.begin(), layer_of_row_.end(), skin_.core_index());
  core_z_ = {static_cast<std::size_t>(rows.first - layer_of_row_.begin()),
             static_cast<std::size_t>(rows.second - layer_of_row_.begin())};
}

MeshLines SkinMesh::lines(const std::array<double, 2>& centre) const {
  return {x_.lines(centre[0], skin_.length), lines_across(centre[1]), z_};
}

std::vector<double> SkinMesh::lines_across(double centre_y) const {
  return y_.lines(centre_y, skin_.width);
}

std::array<std::size_t, 3> SkinMesh::elements() const {
  return {x_.elements(), y_.elements(), z_.size() - 1};
}

} // namespace ionskin::mesh
