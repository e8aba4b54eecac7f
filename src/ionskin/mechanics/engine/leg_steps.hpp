// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/mechanics/engine/leg_levels.hpp"

#include <array>
#include <functional>
#include <optional>

namespace ionskin::mechanics {

/// End of a step along a leg.
struct PassedStep {
  double fraction = 0; ///< of the leg, at the end of the step [1]
  /// Height of a slider that touches nothing [m]; empty: unchanged since the last report.
  std::optional<double> height = {};
  bool required = false; ///< true just before and after a possible jump, which must be stored
};
/// Receives each step that was taken.
/// @returns height of the slider, as it was reported [m]
using PassedSink = std::function<double(const PassedStep&)>;

/// Interface of the ways to move a contact along a part of a leg: on a prescribed path, on a
/// compliant drive, or with adhesion.
class LegSteps {
public:
  /// @param contact must outlive this object
  explicit LegSteps(SlidingContact& contact) : contact_(contact) {}
  virtual ~LegSteps() = default;

  /// Moves the contact from one fraction of a leg towards another, by one or several steps.
  /// @param passed called after every step
  /// @returns fraction that the contact has reached
  /// Throws SolverError when the contact has no solution.
  virtual double advance(const MotionLeg& leg, const LegLevels& levels, double from, double to,
                         const PassedSink& passed) = 0;

  /// Called where the slider lands, at a fraction of a leg.
  virtual void land(const MotionLeg& /*leg*/, double /*fraction*/) {}
  /// Centre of the slider at a fraction of a leg [m].
  virtual std::array<double, 2> centre(const MotionLeg& leg, double fraction) const {
    return leg.centre(fraction * leg.duration);
  }
  /// Force of a drive on the slider at a fraction of a leg, along x and y [N]; 0 without a drive.
  virtual std::array<double, 2> drive_force(const MotionLeg& /*leg*/, double /*fraction*/) const {
    return {};
  }
  /// True if the slider is always on its path. If false, `advance` chooses the lengths of steps
  /// itself, and the slider may move while its path rests.
  virtual bool follows_path() const { return true; }

  int steps() const { return steps_; } ///< number of steps taken so far
  /// Energy lost in jumps of adhesion so far, on the meshed part [J].
  virtual double adhesion_loss() const { return 0; }

protected:
  SlidingContact& contact() const { return contact_; }
  void count_step() { ++steps_; }

private:
  SlidingContact& contact_;
  int steps_ = 0;
};

} // namespace ionskin::mechanics
