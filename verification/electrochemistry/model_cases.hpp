// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/history/core_history.hpp"

#include <vector>

namespace ionskin::verification {

/// Case of the baseline skin (15 x 2 mm, core 0.18 mm) with the electrochemical constants on which
/// the reference values of the rows rest.
Case model_case();

/// Strain history of one lateral column with a shear that is linear through the thickness, from
/// `bottom` to `top` [1], and constant in time. It is switched on at the first sample, which is the
/// only event.
/// @param time instants of the samples [s]
history::CoreHistory linear_step_history(double bottom, double top, std::vector<double> time);

/// Strain history of a slider that touches down, slides and lifts off as in the baseline case, on a
/// grid that moves with the slider: a footprint of 3 x 1.5 mm with soft edges, shear that grows
/// towards the top and along the edges, contact from the last half millisecond of touchdown on,
/// full slip after 17 ms of sliding.
/// @param cycles number of periods of 4 s
history::CoreHistory sliding_contact_history(int cycles);
/// Strain history of the first 0.6 s of `sliding_contact_history`: touchdown and the onset of the
/// slide.
history::CoreHistory slide_onset_history();

} // namespace ionskin::verification
