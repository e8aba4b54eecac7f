// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/slider_track.hpp"

#include "ionskin/case/slider_motion.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ionskin::mechanics {

SliderTrack::SliderTrack(const Case& input) {
  const MotionLeg leg = first_slide(motion_legs(input.motion, input.slider));
  start = leg.from;
  direction = leg.direction();
  stroke = leg.length();
}

std::array<double, 2> SliderTrack::centre(double arc_length) const {
  return {start[0] + arc_length * direction[0], start[1] + arc_length * direction[1]};
}

std::vector<double> interpolation_nodes(double stroke, std::size_t count) {
  std::vector<double> nodes(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = std::numbers::pi * static_cast<double>(i) / static_cast<double>(count - 1);
    nodes[i] = stroke * std::pow(std::sin(angle / 2), 2);
  }
  nodes.front() = 0;
  nodes.back() = stroke;
  return nodes;
}

std::size_t interpolation_node_count(Preset preset) {
  // Even counts: mirrored pairs then fill two threads evenly.
  // Eight interpolate integral(gamma) to 1e-5; six only to 3e-4.
  return preset == Preset::fine ? 12 : 8;
}

std::size_t interpolation_node_count(const Case& input, const std::array<double, 2>& from,
                                     const std::array<double, 2>& to) {
  // Chebyshev interpolation errs by ratio^count. The ratio of the track that the preset's count is
  // meant for follows from its error of 1e-5 with eight nodes.
  constexpr double usual_ratio = 0.237, usual_share = 0.4;
  const double dx = std::abs(to[0] - from[0]), dy = std::abs(to[1] - from[1]);
  const double way = std::hypot(dx, dy);
  const double extent = (dx * input.skin.length + dy * input.skin.width) / way;
  const double share = way / extent / usual_share;
  const auto usual = interpolation_node_count(input.numerics.preset);
  // Lengths are differences of coordinates: their rounding must not cost a node.
  if (share >= 1 - 1e-9) {
    return usual;
  }
  const double count =
      static_cast<double>(usual) * std::log(usual_ratio) / std::log(usual_ratio * share);
  return std::clamp<std::size_t>(static_cast<std::size_t>(std::ceil(count)), 2, usual);
}

std::array<double, 2> CanonicalPosition::reflected(const std::array<double, 2>& vector) const {
  return {reflect[0] ? -vector[0] : vector[0], reflect[1] ? -vector[1] : vector[1]};
}

CanonicalPosition canonical_position(const Skin& skin, const std::array<double, 2>& centre) {
  CanonicalPosition result;
  const std::array<double, 2> size{skin.length, skin.width};
  for (std::size_t d = 0; d < 2; ++d) {
    // A centre on the symmetry line stays unreflected whatever the rounding.
    result.reflect[d] = centre[d] > size[d] / 2 * (1 + 1e-12);
    result.centre[d] = result.reflect[d] ? size[d] - centre[d] : centre[d];
  }
  return result;
}

} // namespace ionskin::mechanics
