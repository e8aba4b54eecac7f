// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mesh/thickness_lines.hpp"

#include "ionskin/mesh/grading.hpp"

#include <algorithm>
#include <limits>

namespace ionskin::mesh {
namespace {

std::vector<double> layer_line(const Layer& layer, const MeshResolution& resolution) {
  const bool core = layer.role == LayerRole::core;
  return two_sided_line(layer.thickness, resolution.core_growth,
                        core ? resolution.core_elements : resolution.electrode_elements);
}

/// Lines through a layer of a thick skin, from the bottom of the layer [m]. Sizes are in geometric
/// progression downwards, that is, in proportion to the depth.
/// @param depth of the top of the layer below the top face [m]
std::vector<double> graded_layer_line(const Layer& layer, double depth, double top_size,
                                      double growth) {
  const double first = top_size + (growth - 1) * depth;
  return reversed(
      graded_line(layer.thickness, first, growth, std::numeric_limits<double>::infinity()));
}

/// Element size at the top face [m]: that of the footprint along the direction without a sharp edge
/// if there is one such direction, or else the smaller one.
double top_size_of(const Footprint& footprint, const MeshResolution& resolution) {
  const auto [along_x, along_y] = resolution.edge_size;
  if (footprint.sharp(0) != footprint.sharp(1)) {
    return footprint.sharp(0) ? along_y : along_x;
  }
  return std::min(along_x, along_y);
}

} // namespace

ThicknessLines thickness_lines(const Skin& skin, const Footprint& footprint,
                               const MeshResolution& resolution) {
  const double side = 2 * std::min(footprint.half_size[0], footprint.half_size[1]);
  const bool thick = skin.thickness() > side;
  ThicknessLines lines{{0.0}, {}};
  double depth = skin.thickness();
  for (std::size_t l = 0; l < skin.layers.size(); ++l) {
    const Layer& layer = skin.layers[l];
    depth = std::max(0.0, depth - layer.thickness);
    append(lines.z, thick ? graded_layer_line(layer, depth, top_size_of(footprint, resolution),
                                              resolution.depth_growth)
                          : layer_line(layer, resolution));
    lines.layer_of_row.resize(lines.z.size() - 1, l);
  }
  return lines;
}

} // namespace ionskin::mesh
