// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mesh/footprint.hpp"

#include "ionskin/case/slider_motion.hpp"

#include <algorithm>
#include <limits>

namespace ionskin::mesh {
namespace {

/// For friction, finite slopes and what else the bounds leave out.
constexpr double allowance = 1.15;
/// Part of the room between slider and skin's edge that is left to the mesh outside.
constexpr double outside_share = 0.1;

double softest_plane_modulus(const Skin& skin) {
  double least = std::numeric_limits<double>::infinity();
  for (const Layer& layer : skin.layers) {
    const double nu = layer.material.poissons_ratio;
    least = std::min(least, layer.material.youngs_modulus / (1 - nu * nu));
  }
  return least;
}

/// Upper bound of the contact's border beyond the part that touches at once.
double round_border(const Case& input, std::size_t direction) {
  const HeaviestLoad load = heaviest_load(input);
  return input.slider.underside()->border(input.slider.plan(),
                                          {load.indentation, load.force,
                                           softest_plane_modulus(input.skin),
                                           std::min(input.slider.size[1], input.skin.width)},
                                          direction);
}

/// Distance from the slider's centre to the nearest edge of the skin over the track.
double room(const Case& input, std::size_t direction) {
  const double size = direction == 0 ? input.skin.length : input.skin.width;
  const MotionBox box = meshed_box(input);
  return std::min(box.low[direction], size - box.high[direction]);
}

} // namespace

HeaviestLoad heaviest_load(const Case& input) {
  HeaviestLoad load;
  for (const MotionLeg& leg : motion_legs(input.motion, input.slider)) {
    for (const SliderLevel& level : {leg.from_level, leg.to_level}) {
      (level.is_force ? load.force : load.indentation) =
          std::max(level.is_force ? load.force : load.indentation,
                   level.is_force ? level.value : -level.value);
    }
  }
  return load;
}

Footprint footprint_limit(const Case& input) {
  const Slider& slider = input.slider;
  const std::array<double, 2> flat = slider.flat_half_size();
  Footprint result;
  for (std::size_t d = 0; d < 2; ++d) {
    if (!slider.sharp()) {
      const double most = std::max(0.0, room(input, d) - flat[d]) * (1 - outside_share);
      result.rim[d] = std::min(slider.size[d] / 2 - flat[d], most);
    }
    result.half_size[d] = flat[d] + result.rim[d];
  }
  return result;
}

Footprint largest_footprint(const Case& input) {
  Footprint result = footprint_limit(input);
  for (std::size_t d = 0; d < 2; ++d) {
    if (!result.sharp(d)) {
      const double flat = result.half_size[d] - result.rim[d];
      result.rim[d] = std::min(allowance * round_border(input, d), result.rim[d]);
      result.half_size[d] = flat + result.rim[d];
    }
  }
  return result;
}

} // namespace ionskin::mesh
