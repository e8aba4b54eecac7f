// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/history/core_history.hpp"

#include <vector>

namespace ionskin::verification {

/// The baseline skin (15 x 2 mm, core 0.18 mm) with the constants behind the reference values.
Case model_case();

/// One column at rest: shear linear through the thickness from `bottom` to `top`, constant in time,
/// switched on at the first sample, which is the only event.
/// @param time samples [s]
history::CoreHistory linear_step_history(double bottom, double top, std::vector<double> time);

/// One period of touchdown, slide and lift-off in the manner of the baseline, on a grid that rides
/// with the slider: a footprint of 3 x 1.5 mm with soft edges, shear that grows towards the top and
/// along the edges, contact during the last half millisecond of touchdown, full slip after 17 ms.
/// @param cycles periods of 4 s
history::CoreHistory sliding_contact_history(int cycles);
/// The first 0.6 s of it: touchdown and the onset of the slide.
history::CoreHistory slide_onset_history();

} // namespace ionskin::verification
