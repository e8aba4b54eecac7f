// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mesh/mesh_resolution.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace ionskin::mesh {
namespace {

/// Width of the zone inside a sharp edge, over the characteristic length [1]. The edge carries a
/// line load, and behind it the surface may lift off. Contact begins again a third to a half of the
/// length further in; with cells as wide as the gap, the cells would decide where.
constexpr double edge_zone_width = 0.6;

/// Least width that is resolved like a rim, over the rim's width [1]: with a smaller one the cells
/// of a slider that tilts much would be too many for a step within a millisecond.
constexpr double least_resolved = 0.5;

struct PresetResolution {
  // Sizes over the characteristic length.
  double edge, footprint_growth, footprint_largest, edge_zone_largest;
  double outer_growth;
  double outer_minimum;
  double face_elements;
  /// Half of the number of elements through the core. The number is even because an element across
  /// the middle, where the shear of squeezing changes its sign, would falsify the mean of its
  /// magnitude by 15 % of the element's share.
  double half_core_elements;
  double core_growth;
  double rim_elements, depth_growth;
};

PresetResolution preset_resolution(Preset preset) {
  switch (preset) {
  case Preset::coarse:
    return {0.12, 2.0, 2.0, 2.0, 2.0, 9, 1, 1, 1.8, 8, 2.0};
  case Preset::standard:
    return {0.05, 2.0, 1.5, 1.5, 2.0, 15, 2, 2, 2.0, 12, 1.7};
  case Preset::fine:
    break;
  }
  return {0.005, 2.0, 1.0, 0.125, 1.8, 26, 3, 3, 1.5, 18, 1.45};
}

std::size_t scaled_count(double count, double refinement) {
  return static_cast<std::size_t>(std::max(1L, std::lround(count * refinement)));
}

} // namespace

std::size_t core_elements(const Numerics& numerics) {
  return 2 * scaled_count(preset_resolution(numerics.preset).half_core_elements,
                          numerics.mesh_refinement * numerics.thickness_refinement);
}

MeshResolution mesh_resolution(const Case& input, const Footprint& footprint) {
  const PresetResolution preset = preset_resolution(input.numerics.preset);
  const double refinement = input.numerics.mesh_refinement;
  const double through_thickness = refinement * input.numerics.thickness_refinement;
  const auto length = [&](std::size_t d) {
    return std::min(input.skin.thickness(), footprint.half_size[d] / 2);
  };
  const double at_sharp_edge = preset.edge * std::min(length(0), length(1)) / refinement;
  const double rim_elements = static_cast<double>(scaled_count(preset.rim_elements, refinement));
  MeshResolution result;
  for (std::size_t d = 0; d < 2; ++d) {
    const bool sharp = footprint.sharp(d);
    const double rim = sharp ? footprint.half_size[d] : footprint.rim[d],
                 resolved = footprint.resolved[d];
    const double in_rim =
        (resolved > 0 ? std::clamp(resolved, least_resolved * rim, rim) : rim) / rim_elements;
    // The edge alone ends the contact under a flat underside.
    const double most = sharp && resolved > 0 ? in_rim : std::numeric_limits<double>::infinity();
    result.edge_size[d] = sharp                ? at_sharp_edge
                          : footprint.round(d) ? in_rim
                                               : std::max(in_rim, at_sharp_edge);
    result.footprint_largest[d] = std::min(most, preset.footprint_largest * length(d) / refinement);
    result.edge_zone[d] = {edge_zone_width * length(d),
                           std::min(most, preset.edge_zone_largest * length(d) / refinement)};
  }
  result.footprint_growth = std::pow(preset.footprint_growth, 1 / refinement);
  result.outer_growth = std::pow(preset.outer_growth, 1 / refinement);
  result.outer_minimum = scaled_count(preset.outer_minimum, refinement);
  result.face_elements = scaled_count(preset.face_elements, through_thickness);
  result.core_elements = core_elements(input.numerics);
  result.core_growth = std::pow(preset.core_growth, 1 / refinement);
  result.electrode_elements = scaled_count(1, refinement);
  result.depth_growth = std::pow(preset.depth_growth, 1 / refinement);
  return result;
}

} // namespace ionskin::mesh
