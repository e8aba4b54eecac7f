// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mesh/footprint.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/case/slider_motion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ionskin::mesh {
namespace {

/// Factor on the bounds of a contact's border, for friction, finite slopes and whatever else the
/// bounds leave out [1].
constexpr double allowance = 1.15;
/// Share of the room between slider and edge of the skin that is left to the mesh outside the
/// footprint [1].
constexpr double outside_share = 0.1;
constexpr double rounding = 1 - 1e-9;

double plane_modulus(const Layer& layer) {
  const double nu = layer.material.poissons_ratio;
  return layer.material.youngs_modulus / (1 - nu * nu);
}

double softest_plane_modulus(const Skin& skin) {
  double least = std::numeric_limits<double>::infinity();
  for (const Layer& layer : skin.layers) {
    least = std::min(least, plane_modulus(layer));
  }
  return least;
}

/// Length over which the layers above the softest one spread a load, as a plate of thickness t: t
/// (E_plate / E_softest)^(1/3) [m].
double spread_of_plate(const Skin& skin, double softest) {
  double thickness = 0, stiffness = 0; // E t
  for (std::size_t i = skin.layers.size(); i-- > 0 && plane_modulus(skin.layers[i]) > softest;) {
    thickness += skin.layers[i].thickness;
    stiffness += plane_modulus(skin.layers[i]) * skin.layers[i].thickness;
  }
  return std::cbrt(thickness * thickness * stiffness / softest);
}

/// Plane-strain modulus of the skin under a contact of half-width a [Pa]. Under a round contact, a
/// plate that spreads loads over L adds E (L / a)^3 to the modulus E of the layer below. Under a
/// line contact the plate bends in one direction only and adds less: there the power is 1. That
/// power and the factor in both cases were fitted to contacts that runs found.
double felt_plane_modulus(const Skin& skin, const Footprint& contact) {
  constexpr double share_of_plate = 4.0 / 3;
  double half_width = std::numeric_limits<double>::infinity();
  for (std::size_t d = 0; d < 2; ++d) {
    if (!contact.sharp(d)) {
      half_width = std::min(half_width, contact.half_size[d]);
    }
  }
  const double softest = softest_plane_modulus(skin);
  const double spread = spread_of_plate(skin, softest) / half_width;
  const bool line = contact.sharp(0) || contact.sharp(1);
  return std::min(plane_modulus(skin.layers.back()),
                  softest * (1 + share_of_plate * (line ? spread : std::pow(spread, 3))));
}

/// Plane-strain modulus of skin and slider in series [Pa]. A soft slider yields at most as much as
/// a half-space.
double common_plane_modulus(const Slider& slider, double of_skin) {
  if (slider.rigid()) {
    return of_skin;
  }
  const double nu = slider.poissons_ratio;
  return 1 / (1 / of_skin + (1 - nu * nu) / slider.youngs_modulus);
}

/// Upper bound of the distance of the contact's border from the part that touches at once, on a
/// half-space with the skin's modulus [m].
double round_border(const Case& input, double of_skin, std::size_t direction) {
  const HeaviestLoad load = heaviest_load(input);
  const double plane_modulus = common_plane_modulus(input.slider, of_skin);
  return input.slider.underside()->border(input.slider.plan(),
                                          {load.indentation, load.force, plane_modulus,
                                           std::min(input.slider.plan().size[1], input.skin.width)},
                                          direction);
}

/// Least distance of the slider's centre from the edges of the skin along its track [m].
double room(const Case& input, std::size_t direction) {
  const double size = direction == 0 ? input.skin.length : input.skin.width;
  const MotionBox box = motion_box(input.motion, input.slider);
  return std::min(box.low[direction], size - box.high[direction]);
}

Footprint footprint_on_even_skin(const Case& input, double plane_modulus) {
  Footprint result = footprint_limit(input);
  for (std::size_t d = 0; d < 2; ++d) {
    if (!result.sharp(d)) {
      const double flat = result.half_size[d] - result.rim[d];
      result.rim[d] = std::min(allowance * round_border(input, plane_modulus, d), result.rim[d]);
      result.half_size[d] = flat + result.rim[d];
    }
  }
  return result;
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

void require_load(const Case& input) {
  const HeaviestLoad load = heaviest_load(input);
  if (load.force <= 0 && load.indentation <= 0) {
    throw UserError(
        "the slider never touches the skin\n  = give a waypoint a height below 0 m, or a force");
  }
}

Footprint footprint_limit(const Case& input) {
  const Slider& slider = input.slider;
  const std::array<double, 2> flat = slider.flat_half_size();
  Footprint result;
  for (std::size_t d = 0; d < 2; ++d) {
    if (!slider.sharp()) {
      const double most = std::max(0.0, room(input, d) - flat[d]) * (1 - outside_share);
      result.rim[d] = std::min(slider.plan().size[d] / 2 - flat[d], most);
    }
    result.half_size[d] = flat[d] + result.rim[d];
  }
  return result;
}

bool ends_at_skin(const Case& input, const Footprint& footprint, std::size_t direction) {
  const Footprint limit = footprint_limit(input);
  return !footprint.sharp(direction) &&
         footprint.rim[direction] >= limit.rim[direction] * rounding &&
         limit.half_size[direction] < input.slider.plan().size[direction] / 2 * rounding;
}

bool ends_at_plan(const Case& input, const Footprint& footprint, std::size_t direction) {
  return footprint.round(direction) && input.slider.underside()->along_axes() &&
         footprint.half_size[direction] >= input.slider.plan().size[direction] / 2 * rounding;
}

Footprint largest_footprint(const Case& input) {
  return footprint_on_even_skin(input, softest_plane_modulus(input.skin));
}

Footprint expected_footprint(const Case& input) {
  constexpr int most_passes = 40;
  constexpr double settled = 1.01;
  double modulus = softest_plane_modulus(input.skin);
  Footprint footprint = footprint_on_even_skin(input, modulus);
  if (input.slider.sharp() || heaviest_load(input).force <= 0) {
    return footprint;
  }
  for (int pass = 0; pass < most_passes; ++pass) { // the smaller it is, the more it feels the plate
    const double felt = felt_plane_modulus(input.skin, footprint);
    if (felt <= settled * modulus) {
      break;
    }
    modulus = felt;
    footprint = footprint_on_even_skin(input, modulus);
  }
  return footprint;
}

} // namespace ionskin::mesh
