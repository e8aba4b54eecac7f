// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/electrochemistry/derived_scales.hpp"
#include "ionskin/strain/strain_history.hpp"

#include <vector>

namespace ionskin::electrochemistry {

/// How the time steps of a preset grow after an event.
struct StepRule {
  double first = 0;   ///< step after an event [s]
  double growth = 0;  ///< largest ratio of neighbouring steps
  double longest = 0; ///< [s]
};

/// The rule for a preset: 1e-5 s after events, up to 25 (fine), 50 or 100 ms (coarse), both shorter
/// where the relaxation or the charging of the core is faster than in Nafion. `time_refinement`
/// divides every step, the excess of the growth over 1 included.
StepRule step_rule(const Numerics& numerics, const DerivedScales& scales);

/// All step ends from the first to the last sample [s], fixed before the run, so that an
/// interrupted run continues on the same steps: they restart at `first` at the beginning and at
/// every event, and land on every sample and on every wanted instant.
std::vector<double> make_time_grid(const strain::StrainHistory& history, const StepRule& rule,
                                   const std::vector<double>& wanted);

} // namespace ionskin::electrochemistry
