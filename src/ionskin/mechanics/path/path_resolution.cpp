// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/path/path_resolution.hpp"

namespace ionskin::mechanics {

double path_resolution(const Numerics& numerics) {
  const double kept = numerics.preset == Preset::coarse ? 20
                      : numerics.preset == Preset::fine ? 80
                                                        : 40;
  return 1 / (kept * numerics.time_refinement);
}

double longest_kept_travel(const Case& input) {
  constexpr double usual_slide = 0.4; // of the skin's length
  return path_resolution(input.numerics) * usual_slide * input.skin.length;
}

double longest_step_turn(const Numerics& numerics) {
  return path_resolution(numerics); // coarse preset: 31 steps in a quarter turn
}

double longest_step_travel(const Case& input) {
  constexpr double steps_per_interval = 2; // fewest steps in the longest stored interval
  return longest_kept_travel(input) / steps_per_interval;
}

} // namespace ionskin::mechanics
