// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/slider_track.hpp"

#include <cmath>
#include <numbers>

namespace ionskin::mechanics {

SliderTrack::SliderTrack(const Case& input)
    : start(input.slider.start), direction(input.motion.direction), stroke(input.motion.stroke) {}

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
