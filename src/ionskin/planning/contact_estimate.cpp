// SPDX-License-Identifier: Apache-2.0
#include "ionskin/planning/contact_estimate.hpp"

#include "ionskin/case/elastic_constants.hpp"
#include "ionskin/case/slider_motion.hpp"

#include <algorithm>
#include <numbers>

namespace ionskin::planning {
namespace {

constexpr double hertz_peak = 1.5; // largest over mean pressure of a round contact
constexpr double margin = 1.5;     // factor of safety of the lower bound

/// Compliances of layers in series under a load per area [m/Pa]. t: thickness, M: oedometric
/// modulus, G: shear modulus, a: half width of the contact.
struct Compliances {
  double confined = 0; ///< sum of t / M: layers that cannot move sideways
  double squeezed = 0; ///< sum of t / M + t^3 / (4 G a^2): bonded strips squeezed out sideways
  double shear = 0;    ///< sum of t / G
};

Compliances compliances(const Skin& skin, double half_width) {
  Compliances sum;
  for (const Layer& layer : skin.layers) {
    const double shear = shear_modulus(layer.material), t = layer.thickness;
    const double confined = t / oedometric_modulus(shear, layer.material.poissons_ratio);
    sum.confined += confined;
    sum.squeezed += confined + t * t * t / (4 * shear * half_width * half_width);
    sum.shear += t / shear;
  }
  return sum;
}

double longest_slide(const Case& input) {
  double longest = 0;
  for (const MotionLeg& leg : joined_slides(motion_legs(input.motion, input.slider))) {
    if (leg.slides())
      longest = std::max(longest, leg.length());
  }
  return longest;
}

bool is_sure(const Case& input) {
  return input.slider.sharp() && input.slider.rigid() && !input.motion.drive.given() &&
         input.contact.law == "coulomb";
}

} // namespace

ContactEstimate estimate_contact(const Case& input, const std::optional<mesh::Footprint>& found) {
  const bool sharp = input.slider.sharp();
  const mesh::Footprint contact = found ? *found : mesh::expected_footprint(input);
  const double half_width = std::min(contact.half_size[0], contact.half_size[1]);
  const double part = sharp ? 4.0 : std::numbers::pi; // area over the product of both half sizes
  ContactEstimate estimate;
  estimate.area = part * contact.half_size[0] * contact.half_size[1];
  const Compliances layers = compliances(input.skin, half_width);
  const mesh::HeaviestLoad load = mesh::heaviest_load(input);
  const double forced = load.force > 0 ? load.force / estimate.area : 0.0;
  estimate.pressure =
      std::max(forced * (sharp ? 1.0 : hertz_peak), load.indentation / layers.confined);
  const double modulus = shear_modulus(input.skin.layers[input.skin.core_index()].material);
  estimate.shear = input.contact.friction * estimate.pressure / modulus;
  if (is_sure(input)) {
    const double pressure = std::max(forced, load.indentation / layers.squeezed);
    const double traction =
        std::min(input.contact.friction * pressure, longest_slide(input) / layers.shear);
    const double depth =
        input.skin.thickness() - input.skin.core_bottom() - input.skin.core_thickness();
    const double reach = half_width / (half_width + depth); // the traction spreads on its way down
    estimate.least_shear = reach * traction / modulus / margin;
  }
  return estimate;
}

} // namespace ionskin::planning
