// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/mechanics/engine/sliding_contact.hpp"

#include <array>
#include <optional>

namespace ionskin::mechanics {

/// Position and velocity of the end of a drive that is guided along the path of the motion; the
/// slider hangs on the other end.
struct DriveEnd {
  std::array<double, 2> place{}, velocity{}; ///< along x and y [m], [m/s]
};

/// Drive of a slider: the slider, of some mass, hangs on a spring and a damper whose other end
/// follows the path of the motion, docs/model.md (38). Velocity and acceleration are backward
/// differences in time of second order on steps of any length (BDF2, Curtiss and Hirschfelder 1952,
/// doi 10.1073/pnas.38.3.235), of first order in the first step. Oscillations that the steps do not
/// resolve are damped, and the position at the end of a step is linear in the force of the skin
/// there.
class CompliantDrive {
public:
  /// @param meshed_share share of the skin's force that its mesh carries, 1 or 0.5 [1]
  /// @param along true, along x and along y, where the slider yields
  CompliantDrive(const Drive& drive, double meshed_share, std::array<bool, 2> along)
      : drive_(drive), meshed_share_(meshed_share), along_(along) {}

  /// Puts the slider at the end of the drive, with the velocity of that end, as where it lands.
  void hold(const DriveEnd& end);
  /// Position of the slider at the end of a step without the force of the skin, and its compliance
  /// to the forces on the cells.
  /// @param time_step [s]
  /// @param end of the drive at the end of the step
  SliderGuide guide(double time_step, const DriveEnd& end) const;
  /// Distance between the position at the end of a step and its extrapolation from the velocity and
  /// acceleration before the step [m].
  /// @param time_step [s]
  /// @param place of the slider at the end of the step [m]
  double surprise(double time_step, const std::array<double, 2>& place) const;
  /// Completes a step that ended at a position, and updates velocity and acceleration.
  /// @param time_step [s]
  /// @param place of the slider at the end of the step [m]
  /// @param end of the drive at the end of the step
  void accept(double time_step, const std::array<double, 2>& place, const DriveEnd& end);

  /// Present position of the slider [m].
  const std::array<double, 2>& place() const { return now_.place; }
  /// Force of the drive on the slider along x and y [N].
  std::array<double, 2> force(const DriveEnd& end) const;

private:
  /// Weights of a backward difference: the rate at the end of a step is `of_new` times the new
  /// value, minus `of_now` times the present value, plus `of_before` times the value before.
  struct Weights {
    double of_new = 0, of_now = 0, of_before = 0; ///< [1/s]
  };
  struct Instant {
    std::array<double, 2> place{}, velocity{}, acceleration{};
  };
  Weights weights(double time_step) const;
  std::array<double, 2> expected(double time_step) const;

  Drive drive_;
  double meshed_share_;
  std::array<bool, 2> along_;
  Instant now_;
  std::optional<Instant> before_;
  double last_step_ = 0; ///< time from `before_` to `now_` [s]
};

} // namespace ionskin::mechanics
