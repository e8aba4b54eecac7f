// SPDX-License-Identifier: Apache-2.0
#include "small_case.hpp"

#include <algorithm>
#include <cmath>

namespace ionskin::mechanics {

Case small_case() {
  Case input;
  const Material metal{"metal", 168e9, 0.38}, polymer{"polymer", 249e6, 0.49};
  input.skin.length = 5e-3;
  input.skin.width = 2e-3;
  input.skin.layers = {{"lower", LayerRole::electrode, metal, 10e-6},
                       {"core", LayerRole::core, polymer, 180e-6},
                       {"upper", LayerRole::electrode, metal, 10e-6}};
  input.slider.size = {1e-3, 0.8e-3};
  input.slider.start = {1.5e-3, 1e-3};
  input.motion.gap = 1e-3;
  input.motion.preload = 1e-6;
  input.motion.stroke = 2e-3;
  input.motion.touchdown = input.motion.lift = 0.5;
  input.motion.slide = 2;
  input.motion.return_ = 1;
  input.contact.friction = 0.3;
  input.numerics.preset = Preset::coarse;
  input.numerics.mesh_refinement = 0.5;
  return input;
}

const SteppedInstant& nearest(const ContactSolution& solution, double time) {
  return *std::ranges::min_element(solution.stepped, {}, [&](const SteppedInstant& instant) {
    return std::abs(instant.time - time);
  });
}

} // namespace ionskin::mechanics
