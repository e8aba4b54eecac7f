// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/path/first_touch.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/mechanics/slider/slider_shape.hpp"
#include "ionskin/mesh/skin_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace ionskin::mechanics {

void require_touch(const Case& input) {
  mesh::require_load(input);
  const mesh::HeaviestLoad load = mesh::heaviest_load(input);
  if (load.force > 0) { // presses until cells touch
    return;
  }
  const Slider& slider = input.slider;
  if (slider.changing.any() || (slider.sharp() && !slider.pose.tilted())) {
    return;
  }
  const mesh::SkinMesh mesh(input, mesh::largest_footprint(input));
  const std::vector<double> gap =
      mean_gap(input.slider, mesh.footprint_lines_x(), mesh.footprint_lines_y(), {false, false});
  const double least = std::ranges::min(gap);
  if (load.indentation > least) {
    return;
  }
  throw UserError(fmt::format(
      "the slider touches no cell of the contact's mesh: it indents by at most {:.3g} um, and its "
      "underside stands {:.3g} um above its lowest point in the mean over the lowest cell\n  = "
      "indent by more than {:.3g} um (motion.preload, or the waypoints' height), raise "
      "numerics.mesh_refinement, or {}",
      load.indentation * 1e6, least * 1e6, least * 1e6,
      slider.pose.tilted() ? "tilt the slider less"
                           : "bring the lowest point of the profile to the slider's centre"));
}

} // namespace ionskin::mechanics
