// SPDX-License-Identifier: Apache-2.0
#include "mechanics/pressed_skin.hpp"
#include "mechanics/rows.hpp"

#include "ionskin/finite_layers/thickness/elastic_layer.hpp"

#include <array>
#include <cmath>

namespace ionskin::verification {
namespace {

/// Computed force over that of a Winkler foundation with the oedometric modulus: a frictionless
/// cylinder on a compressible bonded layer (Johnson, Contact Mechanics, 1985, section 5.8).
double winkler_ratio(double contact_over_thickness) {
  constexpr double thickness = 0.3e-3, indentation = 1e-6;
  const Material material{"foam", 1e9, 0.3};
  const double half_width = contact_over_thickness * thickness;
  Case input;
  input.skin.width = 1e-3;
  input.skin.length = 8 * half_width;
  input.skin.sides = SideCondition::symmetry;
  input.skin.layers = {{"lower", LayerRole::electrode, material, thickness / 3},
                       {"middle", LayerRole::core, material, thickness / 3},
                       {"upper", LayerRole::electrode, material, thickness / 3}};
  input.slider.shape = "cylinder";
  input.slider.parameters["radius"] = half_width * half_width / (2 * indentation);
  input.slider.size = {3 * half_width, 2e-3};
  input.slider.start = {input.skin.length / 2, input.skin.width / 2};
  input.motion.preload = indentation;
  input.numerics.preset = Preset::coarse;
  input.numerics.mesh_refinement = 3;
  PressedSkin skin(input);
  skin.advance({0, 0});
  const double modulus = finite_layers::elastic_layer(material, thickness).oedometric_modulus();
  const double expected =
      4.0 / 3 * modulus * indentation / thickness * half_width * input.skin.width;
  return skin.force(0) / expected;
}

} // namespace

std::vector<Row> thin_layer_rows() {
  std::array<double, 3> error{};
  for (std::size_t i = 0; i < error.size(); ++i) {
    error[i] = std::abs(winkler_ratio(4 * std::pow(2.0, static_cast<double>(i))) - 1);
  }
  return {
      at_most("M2", "thin bonded layer, 16 times as wide: force against Winkler's", error[2], 0.01),
      at_least("M2", "thin bonded layer: order in thickness over width",
               std::log2(error[1] / error[2]), 1.5)};
}

} // namespace ionskin::verification
