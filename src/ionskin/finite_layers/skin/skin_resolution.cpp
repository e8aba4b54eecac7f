// SPDX-License-Identifier: Apache-2.0
#include "ionskin/finite_layers/skin/skin_resolution.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ionskin::finite_layers {
namespace {

// Smallest and largest reach of short waves, over the thickness of the skin. The box in which the
// strain of short waves is summed grows with their reach.
constexpr double least_reach = 0.75, most_reach = 2.5;

} // namespace

FaceResolution SkinResolution::face(double length) const {
  const double last = fading_end * face_waves / reach;
  return {static_cast<Eigen::Index>(std::ceil(last * length / std::numbers::pi)) + 1, one_by_one};
}

SkinResolution skin_resolution(const std::vector<ElasticLayer>& layers, const Clearance& clearance,
                               SkinPurpose purpose) {
  constexpr double thick = 0.2; // share of the whole thickness; a thicker layer bends by itself
  double thickness = 0;
  for (const ElasticLayer& layer : layers) {
    thickness += layer.thickness;
  }
  SkinResolution result;
  result.split_tolerance = 1e-3;
  result.reach = std::clamp(2 * std::min(clearance.ends, clearance.sides), least_reach * thickness,
                            most_reach * thickness);
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
