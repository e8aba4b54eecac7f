// SPDX-License-Identifier: Apache-2.0
#include "ionskin/finite_layers/skin/skin_resolution.hpp"

#include "ionskin/finite_layers/thickness/elastic_layer.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ionskin::finite_layers {
namespace {

// Smallest and largest reach of short waves, over the thickness of the skin. Near loads and several
// sliders must be further apart than the reach.
constexpr double least_reach = 0.75, usual_reach = 2.5;
/// Area of the skin over the square of the reach, beyond which the modes of the skin, whose number
/// is proportional to it, cost more than the rest: a skin this thin has a longer reach.
constexpr double most_modes = 1000;

/// Largest half power of 2 of a reach within a clearance, at least the reach [m].
double reach_of_face(double reach, double clearance) {
  return reach * std::exp2(0.5 * std::floor(2 * std::log2(std::max(1.0, clearance / reach))));
}

} // namespace

FaceResolution SkinResolution::face(double face_reach, double length) const {
  const double last = fading_end * face_waves / face_reach;
  return {static_cast<Eigen::Index>(std::ceil(last * length / std::numbers::pi)) + 1, one_by_one};
}

SkinResolution skin_resolution(const Skin& skin, const Clearance& clearance, SkinPurpose purpose) {
  constexpr double thick = 0.2; // share of the whole thickness; a thicker layer bends by itself
  const std::vector<ElasticLayer> layers = elastic_layers(skin);
  double thickness = 0;
  for (const ElasticLayer& layer : layers) {
    thickness += layer.thickness;
  }
  SkinResolution result;
  result.split_tolerance = 1e-3;
  const double most_reach =
      std::max(usual_reach * thickness, std::sqrt(skin.length * skin.width / most_modes));
  result.reach = std::clamp(2 * std::min(clearance.ends, clearance.sides), least_reach * thickness,
                            most_reach);
  result.ends_reach = reach_of_face(result.reach, clearance.ends);
  result.sides_reach = reach_of_face(result.reach, clearance.sides);
  const bool results = purpose == SkinPurpose::results;
  result.face_waves = results ? 5 : 3;
  result.one_by_one = results ? 120 : 60;
  result.degree = results ? 5 : 3;
  for (const ElasticLayer& layer : layers) {
    result.elements.push_back(layer.thickness > thick * thickness ? ElementSizes{1, 2, 2, 1}
                                                                  : ElementSizes{1});
  }
  return result;
}

} // namespace ionskin::finite_layers
