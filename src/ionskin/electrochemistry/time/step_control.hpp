// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/electrochemistry/grid/derived_scales.hpp"
#include "ionskin/electrochemistry/time/step_landings.hpp"

#include <cstddef>
#include <utility>
#include <vector>

namespace ionskin::electrochemistry {

/// Rule to which the length of time steps is held.
struct StepRule {
  double tolerance = 0;    ///< error of the charge that one step may add, over the charge so far
  double first = 0;        ///< first trial after an event [s]
  double longest = 0;      ///< while less than `longest / late_share` has passed since an event [s]
  double late_share = 0;   ///< longest step over the time since the last event, from then on [1]
  double shortest = 0;     ///< below it the solver gives up [s]
  double growth = 0;       ///< of a step over the one before it, at most
  double column_share = 0; ///< of the errors of single columns, see `ChargeNorm::of_change`
};

/// The rule for a case: the tolerance is the user's or the preset's; after events a first step of
/// 1e-5 s is tried, a shorter one where the core charges faster than Nafion, and steps reach up to
/// 0.177 of the time in which the double layers charge, or to 0.05 of the time since the last
/// event where that is more. `time_refinement` divides steps, so it divides the tolerance by its
/// third power, that of the error of a step. Taxels ask for the charges of single columns;
/// whole electrodes do with a tenth of their share in the error.
StepRule step_rule(const Numerics& numerics, const Readout& readout, const DerivedScales& scales);

/// Time tolerance of a preset.
double preset_tolerance(Preset preset);

/// Chooses the ends of the steps: on every landing, as long as the error allows in between, small
/// after events (elementary controller with limits: Hairer, Norsett and Wanner, Solving Ordinary
/// Differential Equations I, 1993, section II.4).
class StepControl {
public:
  StepControl(StepLandings landings, const StepRule& rule);

  const StepLandings& landings() const { return landings_; }

  /// First and last instant [s].
  std::pair<double, double> span() const { return {landings_.time.front(), landings_.time.back()}; }
  /// True if step ends so far are those of a run with these landings [s].
  bool has_landed(const std::vector<double>& ends) const;

  /// The step to start a run with [s].
  double first_step() const { return rule_.first; }
  bool finished(double time) const { return time >= landings_.time.back(); }
  /// End of the step from `time` whose length should be `wanted`: exactly on a landing when that is
  /// near, and never so that a sliver remains [s].
  double step_end(double time, double wanted) const;
  /// Length to try after a finished step [s].
  /// @param wanted length that `step_end` was asked for
  /// @param error of the step over the allowed error
  double after_success(double begin, double end, double wanted, double error) const;
  /// Length to try instead of a step whose error was too large [s].
  double after_rejection(double begin, double end, double error) const;
  /// Length to try instead of a step without a solution [s].
  double after_failure(double begin, double end) const { return 0.25 * (end - begin); }

  double tolerance() const { return rule_.tolerance; }
  /// Share of the errors of single columns in the error of a step from `begin`: larger on the way
  /// to a landing where the fields are kept.
  double column_share(double begin) const;
  bool too_short(double wanted) const { return !(wanted >= rule_.shortest); } ///< or not a number

private:
  /// Longest step from an instant [s].
  double longest(double time) const;

  StepLandings landings_;
  StepRule rule_;
  std::vector<double> event_; ///< at or before each landing; the first landing before any [s]
};

/// Length that the tolerance is likely to allow while charge relaxes with the slow time T [s]: the
/// error of a step h of TR-BDF2 is 0.0404 h^3 times the third derivative of the charge (Bank et al.
/// 1985), which is the charge over T^3.
double relaxation_step(const StepRule& rule, const DerivedScales& scales);

/// Length of a step that the tolerance is likely to allow while the slider's edges cross the
/// columns of the grid [s]. At either end of a crossing the fixed charge of a column has a kink,
/// whose error is of second order in the step over the time of a crossing t: h = 0.85 t
/// sqrt(tolerance/(0.055 share)) with the share of columns. The constant is measured on the
/// baseline, at tolerances from 1.5e-6 to 1e-4 and shares of 0.001 and 0.01, within a third.
/// @param crossing_time column width over speed [s]
double crossing_step(const StepRule& rule, double crossing_time);

/// Number of steps a run is likely to take, for estimates before it: landings, the growth of the
/// steps behind events, and what the tolerance allows.
/// @param longest step per interval between neighbouring landings [s]
std::size_t estimate_steps(const StepLandings& landings, const StepRule& rule,
                           const std::vector<double>& longest);

} // namespace ionskin::electrochemistry
