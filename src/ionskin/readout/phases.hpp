// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/slider_motion.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace ionskin::readout {

/// State of the prescribed motion at an instant (docs/model.md (1)).
struct MotionInstant {
  int cycle = 1;                  ///< from 1
  std::string phase;              ///< touchdown, slide, lift or return
  std::array<double, 2> centre{}; ///< of the slider [m]
  /// Level that is given there; on the way between a height and a force neither is.
  std::optional<SliderLevel> level;
};

/// The cycles of a run on its time axis.
class MotionPhases {
public:
  MotionPhases(const Motion& motion, const Slider& slider);

  /// Phases are half-open intervals (start, end]: an instant on a boundary belongs to the phase
  /// that ends there, as the currents of its row are means over the step that ends there. The start
  /// of the run belongs to the first touchdown.
  /// @param time since the start of the run [s]
  MotionInstant at(double time) const;

private:
  std::vector<MotionLeg> legs_;
  int cycles_ = 1;
  double duration_ = 0; ///< of one cycle [s]
};

/// The instants of the named quantities of summary.json, in the first cycle [s]: the end of the
/// first touchdown, and the middle of the first slide, or of the hold where nothing slides.
double end_of_touchdown(const Motion& motion, const Slider& slider);
double middle_of_slide(const Motion& motion, const Slider& slider);
/// End of the same slide or hold.
double end_of_slide(const Motion& motion, const Slider& slider);

} // namespace ionskin::readout
