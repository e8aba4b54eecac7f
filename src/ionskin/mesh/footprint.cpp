// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mesh/footprint.hpp"

#include "ionskin/case/slider_motion.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>
#include <vector>

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

double sphere_contact(const Case& input) {
  const HeaviestLoad load = heaviest_load(input);
  const double radius = input.slider.radius;
  return std::max(2 * std::sqrt(radius * load.indentation),
                  std::cbrt(0.75 * load.force * radius / softest_plane_modulus(input.skin)));
}

/// Half width of a line contact.
double cylinder_contact(const Case& input, double radius) {
  const HeaviestLoad load = heaviest_load(input);
  const double length = std::min(input.slider.size[1], input.skin.width);
  return std::max(std::sqrt(6 * radius * load.indentation),
                  std::sqrt(4 * load.force * radius /
                            (std::numbers::pi * length * softest_plane_modulus(input.skin))));
}

/// Farthest from the centre that a line of heights lies below a level, within +-half; 0 where it
/// does not.
double reach_below(const std::vector<double>& places, const std::vector<double>& heights,
                   double level, double half) {
  double reach = 0;
  for (std::size_t i = 1; i < places.size(); ++i) {
    const double low = std::max(places[i - 1], -half), high = std::min(places[i], half);
    const double slope = (heights[i] - heights[i - 1]) / (places[i] - places[i - 1]);
    const double at_low = heights[i - 1] + slope * (low - places[i - 1]),
                 at_high = heights[i - 1] + slope * (high - places[i - 1]);
    if (low >= high || std::min(at_low, at_high) >= level) {
      continue;
    }
    const double crossing = slope == 0 ? low : low + (level - at_low) / slope;
    reach = std::max({reach, std::abs(at_low < level ? low : crossing),
                      std::abs(at_high < level ? high : crossing)});
  }
  return reach;
}

/// How far from the centre the undeformed skin would reach into a height map. Between grid lines
/// the heights are linear along each direction: the least along y of every x is on a line y =
/// const.
double profile_contact(const Case& input, std::size_t direction) {
  const HeaviestLoad load = heaviest_load(input);
  if (load.force > 0) {
    return std::numeric_limits<double>::infinity();
  }
  const HeightMap& map = input.slider.profile_heights;
  const std::array<double, 2> half{input.slider.size[0] / 2, input.slider.size[1] / 2};
  const double level = map.lowest(input.slider.size) + load.indentation;
  const std::vector<double>&along = direction == 0 ? map.x : map.y,
        &across = direction == 0 ? map.y : map.x;
  const double half_across = half[1 - direction];
  std::vector<double> lines{std::max(-half_across, across.front()),
                            std::min(half_across, across.back())};
  std::ranges::copy_if(across, std::back_inserter(lines),
                       [&](double line) { return std::abs(line) < half_across; });
  double reach = 0;
  std::vector<double> heights(along.size());
  for (const double line : lines) {
    std::ranges::transform(along, heights.begin(), [&](double at) {
      return direction == 0 ? map.interpolated(at, line) : map.interpolated(line, at);
    });
    reach = std::max(reach, reach_below(along, heights, level, half[direction]));
  }
  return reach;
}

/// Width of the contact's border beyond the part that touches at once.
double round_border(const Case& input, std::size_t direction) {
  switch (input.slider.shape) {
  case SliderShape::flat:
    // Under a given force the indentation is not known beforehand.
    return heaviest_load(input).force > 0 ? input.slider.edge_radius
                                          : cylinder_contact(input, input.slider.edge_radius);
  case SliderShape::cylinder:
    return cylinder_contact(input, input.slider.radius);
  case SliderShape::sphere:
    return sphere_contact(input);
  case SliderShape::profile:
    break;
  }
  return profile_contact(input, direction);
}

/// Distance from the slider's centre to the nearest edge of the skin over the track.
double room(const Case& input, std::size_t direction) {
  const double size = direction == 0 ? input.skin.length : input.skin.width;
  const MotionBox box = motion_box(input.motion, input.slider);
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
    if (!slider.sharp() && !(slider.shape == SliderShape::cylinder && d == 1)) {
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
