// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/slider_motion.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace ionskin::readout {

/// State of the slider's prescribed motion at an instant, docs/model.md (1).
struct MotionInstant {
  int cycle = 1;                  ///< number of the cycle, from 1
  std::string phase;              ///< touchdown, slide, lift or return
  std::array<double, 2> centre{}; ///< of the slider, x and y [m]
  /// Height or force that the motion prescribes; empty between a prescribed height and a prescribed
  /// force, where the motion gives neither.
  std::optional<SliderLevel> level;
};

/// Maps the time of a run to cycle, phase and prescribed position of the slider.
class MotionPhases {
public:
  MotionPhases(const Motion& motion, const Slider& slider);

  /// State of the motion at an instant. Phases are half-open intervals (start, end]: an instant on
  /// a boundary belongs to the phase that ends there, since the currents of its row are means over
  /// the step that ends there. The start of the run belongs to the first touchdown.
  /// @param time since the start of the run [s]
  MotionInstant at(double time) const;

private:
  std::vector<MotionLeg> legs_;
  int cycles_ = 1;
  double duration_ = 0; ///< of one cycle [s]
};

/// End of the first touchdown, an instant for quantities of summary.json; 0 if the slider never
/// lands [s].
double end_of_touchdown(const Motion& motion, const Slider& slider);
/// Middle of the first slide, or of the hold in contact if the slider never slides: the other
/// instant for quantities of summary.json [s].
double middle_of_slide(const Motion& motion, const Slider& slider);
/// End of the first slide, or of the hold in contact if the slider never slides [s].
double end_of_slide(const Motion& motion, const Slider& slider);

} // namespace ionskin::readout
