// SPDX-License-Identifier: Apache-2.0
#include "mechanics/baseline_case.hpp"

namespace ionskin::verification {

Case baseline_case() {
  const Material platinum{"platinum", 168e9, 0.38}, nafion{"nafion", 249e6, 0.49};
  Case input;
  input.skin.length = 15e-3;
  input.skin.width = 2e-3;
  input.skin.layers = {{"bottom electrode", LayerRole::electrode, platinum, 10e-6},
                       {"core", LayerRole::core, nafion, 180e-6},
                       {"top electrode", LayerRole::electrode, platinum, 10e-6}};
  input.slider.size = {3e-3, 1.5e-3};
  input.slider.start = {4.5e-3, 1e-3};
  input.motion.gap = 1e-3;
  input.motion.preload = 1e-6;
  input.motion.stroke = 6e-3;
  input.motion.touchdown = 0.5;
  input.motion.slide = 2;
  input.motion.lift = 0.5;
  input.motion.return_ = 1;
  input.motion.cycles = 3;
  input.contact.friction = 0.3;
  input.numerics.preset = Preset::coarse;
  return input;
}

} // namespace ionskin::verification
