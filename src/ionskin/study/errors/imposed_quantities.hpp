// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/readout/metrics.hpp"
#include "ionskin/readout/signals.hpp"
#include "ionskin/study/metrics/read_out.hpp"

#include <vector>

namespace ionskin::study {

/// Errors of quantities that the case prescribes, such as a normal force or a height of the slider.
/// Another mesh or other steps do not move them, so that their error is not estimated from coarser
/// solutions.
struct ImposedErrors {
  std::vector<readout::Metric> metrics; ///< errors by the name of a metric, in its unit
  /// Errors by column of signals.csv, one entry per row; NaN where the quantity is solved for.
  std::vector<readout::Signal> signals;
};

/// Computes the distance of prescribed quantities from their prescription. Prescribed are: the
/// normal force where the motion goes by force, presses and has landed (its error is at least the
/// tolerance of the contact solver), and with it the tangential force in mid-slide if the contact
/// slips as a whole under a friction proportional to the pressure; the height of the slider where
/// it goes by height; and the position along the skin of a slider on a rail, or of the end of a
/// drive, at any time. Not prescribed are height and force on the way from one to the other, and a
/// pulling force, as the pull may end earlier on another mesh. Empty for a given strain.
ImposedErrors imposed_errors(const Case& input, const Signals& signals);

} // namespace ionskin::study
