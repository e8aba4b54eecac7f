// SPDX-License-Identifier: Apache-2.0
#include "ionskin/poroelasticity/validity.hpp"

#include "ionskin/base/constants.hpp"
#include "ionskin/case/slider_motion.hpp"
#include "ionskin/poroelasticity/water_properties.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace ionskin::poroelasticity {
namespace {

constexpr double longest_hold = 0.03; // largest c_v t/h^2 of a held indentation without a warning

/// Self-diffusivity of water in wet Nafion, in the order that NMR measures [m2/s], and the volume
/// fraction of water if the case does not give it [1].
constexpr double self_diffusivity = 5e-10, usual_share = 0.4;

/// Relative errors of the pressure difference between the walls, and at late times of the dilution,
/// at c_v t/h^2 of 0.01, 0.1 and 1.
using ErrorRow = std::array<double, 3>;
constexpr ErrorRow under_force{0.02, 0.22, 0.35}, under_indentation{0.07, 0.46, 1.3};

double logarithmic(const ErrorRow& row, double number) {
  // Errors are proportional to the number below the table; above it they only show that the error
  // is large.
  if (number <= 0.01) {
    return row[0] * number / 0.01;
  }
  const double place = std::min(std::log10(number) + 2, 2.0);
  const std::size_t at = place < 1 ? 0 : 1;
  return row[at] + (row[at + 1] - row[at]) * (place - static_cast<double>(at));
}

std::string warn_about_held_indentation(const Case& input) {
  const Holding hold = holding(input);
  if (hold.by_force || hold.number <= longest_hold) {
    return "";
  }
  return fmt::format(
      "The slider holds an indentation for {:.3g} s, c_v t/h^2 = {:.3g}: beyond {:.2g} the water "
      "leaves and the load relaxes, which Study 1 does not follow, so that pore pressure stays too "
      "high. Press with a force, such as motion.preload = \"2 N\", or hold for less than {:.3g} s.",
      hold.time, hold.number, longest_hold, hold.time * longest_hold / hold.number);
}

std::string warn_about_slow_water(const Case& input) {
  const WaterProperties water = derive_water_properties(input);
  const double share = input.water.volume_fraction > 0 ? input.water.volume_fraction : usual_share;
  const double least = self_diffusivity * share * constants::molar_volume_of_water /
                       (constants::gas_constant * input.electrochemistry.temperature);
  // In humid air water moves more slowly than in a wet core, and the material gives its mobility.
  if (water.mobility >= least || input.skin.humidity > 0) {
    return "";
  }
  return fmt::format(
      "Water moves more slowly than it diffuses by itself: the mobility {:.3g} m2/(Pa s) is below "
      "{:.2g} m2/(Pa s), which a self-diffusivity of {:.0e} m2/s makes. Sorption measures such "
      "values, as swelling and the surface hold it up (Majsztrik et al. 2007, J. Membr. Sci. 301, "
      "93); take water.permeability of a permeation experiment.",
      water.mobility, least, self_diffusivity);
}

} // namespace

Holding holding(const Case& input) {
  Holding hold;
  if (input.strain.kind != StrainSourceKind::contact) {
    return hold;
  }
  double time = 0;
  hold.by_force = true;
  for (const MotionLeg& leg : motion_legs(input.motion, input.slider)) {
    if (!leg.touches()) {
      time = 0;
      continue;
    }
    const ContactPart part = contact_part(leg);
    const bool forced = part.from_level.is_force || part.to_level.is_force;
    hold.by_force = hold.by_force && forced;
    time = leg.lands() ? part.duration : time + part.duration;
    hold.time = std::max(hold.time, time);
  }
  const double thickness = input.skin.core_thickness();
  hold.number = derive_water_properties(input).consolidation_coefficient * hold.time /
                (thickness * thickness);
  return hold;
}

double decoupling_error(const Case& input) {
  const Holding hold = holding(input);
  return logarithmic(hold.by_force ? under_force : under_indentation, hold.number);
}

std::vector<std::string> validity_warnings(const Case& input) {
  std::vector<std::string> warnings;
  for (std::string warning : {warn_about_held_indentation(input), warn_about_slow_water(input)}) {
    if (!warning.empty()) {
      warnings.push_back(std::move(warning));
    }
  }
  return warnings;
}

} // namespace ionskin::poroelasticity
