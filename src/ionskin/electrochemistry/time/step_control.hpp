// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/electrochemistry/grid/derived_scales.hpp"
#include "ionskin/electrochemistry/time/step_landings.hpp"

#include <cstddef>
#include <utility>
#include <vector>

namespace ionskin::electrochemistry {

/// Rule for the length of time steps: tolerance and limits.
struct StepRule {
  /// Error of the charge allowed in one step, over the largest charge so far [1].
  double tolerance = 0;
  double first = 0; ///< length of the first step tried after an event [s]
  /// Longest step, until `late_share` of the time since the event is longer [s].
  double longest = 0;
  double late_share = 0; ///< longest step over the time since the last event, from then on [1]
  double shortest = 0;   ///< length of a step below which the solver gives up [s]
  double growth = 0;     ///< largest ratio of a step to the one before it [1]
  /// Weight of the errors of single columns, see `ChargeNorm::of_change` [1].
  double column_share = 0;
};

/// Makes the rule for a case. The tolerance is the user's or the preset's. After an event a first
/// step of 1e-5 s is tried, or of a thousandth of the charging time of the double layers where that
/// is shorter. Steps reach up to 0.177 of that charging time, or 0.05 of the time since the last
/// event where that is more. `time_refinement` divides steps, so it divides the tolerance by its
/// third power, as the error of a step is of third order. Taxels need the charges of single
/// columns; with whole electrodes the weight of single columns is a tenth of that.
StepRule step_rule(const Numerics& numerics, const Readout& readout, const DerivedScales& scales);

/// Tolerance of a preset for the error of the charge in one time step [1].
double preset_tolerance(Preset preset);

/// Control of the time steps: chooses where steps end, namely on every landing, as far apart as the
/// error allows in between, and close together after events (elementary controller with limits:
/// Hairer, Norsett and Wanner, Solving Ordinary Differential Equations I, 1993, section II.4).
class StepControl {
public:
  StepControl(StepLandings landings, const StepRule& rule);

  const StepLandings& landings() const { return landings_; }

  /// First and last instant of the run [s].
  std::pair<double, double> span() const { return {landings_.time.front(), landings_.time.back()}; }
  /// True if the instants at which the steps of a run have ended so far [s] belong to a run with
  /// these landings.
  bool has_landed(const std::vector<double>& ends) const;

  /// Length of the first step of a run to try [s].
  double first_step() const { return rule_.first; }
  bool finished(double time) const { return time >= landings_.time.back(); }
  /// Chooses the end of the step from `time` whose length should be `wanted` [s]: exactly on the
  /// next landing when that is near, else so that no tiny step remains before the landing.
  double step_end(double time, double wanted) const;
  /// Computes the length to try after an accepted step [s].
  /// @param wanted length for which `step_end` was asked [s]
  /// @param error error of the step over the allowed error [1]
  double after_success(double begin, double end, double wanted, double error) const;
  /// Computes the length to try instead of a step whose error was too large [s].
  /// @param error error of the step over the allowed error [1]
  double after_rejection(double begin, double end, double error) const;
  /// Computes the length to try instead of a step for which the solver found no solution [s].
  double after_failure(double begin, double end) const { return 0.25 * (end - begin); }

  double tolerance() const { return rule_.tolerance; }
  /// Weight of the errors of single columns in the error of a step from `begin` [s]: larger on the
  /// way to a landing at which fields are stored.
  double column_share(double begin) const;
  /// True if a step is too short to go on, or not a number.
  bool too_short(double wanted) const { return !(wanted >= rule_.shortest); }

private:
  /// Longest step from an instant [s].
  double longest(double time) const;

  StepLandings landings_;
  StepRule rule_;
  std::vector<double> event_; ///< event at or before each landing, else the first landing [s]
};

/// Estimates the length of a step that the tolerance allows while charge relaxes with the slow time
/// T (`slow_time`) [s]: the error of a step h of TR-BDF2 is 0.0404 h^3 times the third derivative
/// of the charge (Bank et al. 1985), which is the charge over T^3.
double relaxation_step(const StepRule& rule, const DerivedScales& scales);

/// Estimates the length of a step that the tolerance allows while the slider's edges cross the
/// columns of the grid [s]. At both ends of a crossing the fixed charge of a column has a kink,
/// whose error is of second order in the step over the time of a crossing t: h = 0.85 t
/// sqrt(tolerance/(0.055 share)) with the weight `column_share`. The constant is measured on the
/// baseline, at tolerances from 1.5e-6 to 1e-4 and weights of 0.001 and 0.01, within a third.
/// @param crossing_time column width over the slider's speed [s]
double crossing_step(const StepRule& rule, double crossing_time);

/// Estimates the number of time steps of a run from its landings, the growth of steps after events,
/// the share of the time since the last event, and the lengths that the tolerance allows.
/// @param relaxing longest step until that share is longer [s], such as `relaxation_step`
/// @param longest longest step in each interval between neighbouring landings, however late [s]
std::size_t estimate_steps(const StepLandings& landings, const StepRule& rule, double relaxing,
                           const std::vector<double>& longest);

} // namespace ionskin::electrochemistry
