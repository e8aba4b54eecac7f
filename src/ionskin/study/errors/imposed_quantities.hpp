// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/readout/metrics.hpp"
#include "ionskin/readout/signals.hpp"
#include "ionskin/study/metrics/read_out.hpp"

#include <vector>

namespace ionskin::study {

/// Errors of what the case gives and Study 1 does not solve for: another mesh or other steps do not
/// move it.
struct ImposedErrors {
  std::vector<readout::Metric> metrics; ///< error by the name of a metric
  std::vector<readout::Signal> signals; ///< columns of signals.csv; NaN where a row is solved for
};

/// Distance of the results from what is given. A normal force is given where the motion goes by
/// force, presses and has landed, and its error is at least what the contact is solved to; a height
/// where it goes by height; the place of a slider on a rail, or of the end of a drive, always. On
/// the way between a height and a force both are solved for, and a pull may end earlier on another
/// mesh. Empty for a given strain.
ImposedErrors imposed_errors(const Case& input, const Signals& signals);

} // namespace ionskin::study
