// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/mechanics/engine/leg_levels.hpp"

#include <array>
#include <functional>
#include <optional>

namespace ionskin::mechanics {

/// State with which a step of a leg ends.
struct PassedStep {
  double fraction = 0; ///< of the leg
  /// Height of a slider that touches nothing; empty where it stands as it was last reported [m].
  std::optional<double> height = {};
  bool required = false; ///< before and behind what may be a jump
};
/// Receiver of every step that was passed.
/// @returns the height of the slider that was reported [m]
using PassedSink = std::function<double(const PassedStep&)>;

/// Steps by which a contact is moved over a part of a leg: as its motion prescribes it, or on a
/// drive, or held by adhesion.
class LegSteps {
public:
  /// @param contact outlives this
  explicit LegSteps(SlidingContact& contact) : contact_(contact) {}
  virtual ~LegSteps() = default;

  /// Moves the contact from a fraction of a leg towards another.
  /// @param passed called with every step
  /// @returns the fraction that it reached
  /// Throws SolverError when the contact has no solution.
  virtual double advance(const MotionLeg& leg, const LegLevels& levels, double from, double to,
                         const PassedSink& passed) = 0;

  /// The slider lands at a fraction of a leg.
  virtual void land(const MotionLeg& /*leg*/, double /*fraction*/) {}
  /// Where the slider is at a fraction of a leg [m], and the force of a drive on it [N].
  virtual std::array<double, 2> centre(const MotionLeg& leg, double fraction) const {
    return leg.centre(fraction * leg.duration);
  }
  virtual std::array<double, 2> drive_force(const MotionLeg& /*leg*/, double /*fraction*/) const {
    return {};
  }
  /// True if the place of the slider is that of its path; if not, steps find their length
  /// themselves, and a slider that rests may still move.
  virtual bool follows_path() const { return true; }

  int steps() const { return steps_; } ///< number of steps taken
  /// Energy that adhesion has lost in jumps [J].
  virtual double adhesion_loss() const { return 0; }

protected:
  SlidingContact& contact() const { return contact_; }
  void count_step() { ++steps_; }

private:
  SlidingContact& contact_;
  int steps_ = 0;
};

} // namespace ionskin::mechanics
