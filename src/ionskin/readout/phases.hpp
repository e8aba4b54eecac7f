// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"

#include <string>

namespace ionskin::readout {

/// Where the prescribed motion stands at an instant (design equations 5 to 8).
struct MotionInstant {
  int cycle = 1;       ///< from 1
  std::string phase;   ///< touchdown, slide, lift or return
  double slider_x = 0; ///< centre of the slider [m]
  double slider_z = 0; ///< underside above the undeformed top face; negative when indented [m]
};

/// Phases are half-open intervals (start, end]: an instant on a boundary belongs to the phase that
/// ends there, as the currents of its row are means over the step that ends there. The start of the
/// run belongs to the first touchdown.
/// @param time since the start of the run [s]
MotionInstant motion_at(const Motion& motion, const Slider& slider, double time);

/// The instants of the named quantities of summary.json, in the first cycle [s].
double end_of_touchdown(const Motion& motion);
double middle_of_slide(const Motion& motion);

} // namespace ionskin::readout
