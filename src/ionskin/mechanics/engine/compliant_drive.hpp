// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/mechanics/engine/sliding_contact.hpp"

#include <array>
#include <optional>

namespace ionskin::mechanics {

/// Place and velocity of the end of a drive that the slider hangs on.
struct DriveEnd {
  std::array<double, 2> place{}, velocity{}; ///< [m], [m/s]
};

/// A slider of some mass on a spring and a damper whose other end goes along the path of the
/// motion, docs/model.md (38). Velocity and acceleration are differences backwards in time of
/// second order on steps of any length (BDF2, Curtiss and Hirschfelder 1952, doi
/// 10.1073/pnas.38.3.235), of first order in the first step: what the steps do not resolve dies
/// out, and the place at the end of a step is linear in the force of the skin there.
class CompliantDrive {
public:
  /// @param meshed_share part of the force of the skin that its mesh carries
  /// @param along whether the slider yields along x and along y
  CompliantDrive(const Drive& drive, double meshed_share, std::array<bool, 2> along)
      : drive_(drive), meshed_share_(meshed_share), along_(along) {}

  /// The slider stands at the end of the drive and moves with it, as where it lands.
  void hold(const DriveEnd& end);
  /// Where the slider would be at the end of a step, and how it yields to the cells' forces.
  SliderGuide guide(double time_step, const DriveEnd& end) const;
  /// Distance of a place at the end of a step from where the motion so far would have led [m].
  double surprise(double time_step, const std::array<double, 2>& place) const;
  /// Takes the step that led to a place.
  void accept(double time_step, const std::array<double, 2>& place, const DriveEnd& end);

  const std::array<double, 2>& place() const { return now_.place; }
  /// Force of the drive on the slider [N].
  std::array<double, 2> force(const DriveEnd& end) const;

private:
  /// A rate at the end of a step is `of_new` times the new value, less `of_now` times the present
  /// one, plus `of_before` times the one before.
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
  double last_step_ = 0; ///< between both [s]
};

} // namespace ionskin::mechanics
