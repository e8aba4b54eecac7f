// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/engine/compliant_drive.hpp"

#include <cmath>

namespace ionskin::mechanics {

void CompliantDrive::hold(const DriveEnd& end) {
  now_ = {end.place, end.velocity, {}};
  before_.reset();
}

CompliantDrive::Weights CompliantDrive::weights(double time_step) const {
  if (!before_) {
    return {1 / time_step, 1 / time_step, 0};
  }
  const double ratio = time_step / last_step_;
  return {(1 + 2 * ratio) / (1 + ratio) / time_step, (1 + ratio) / time_step,
          ratio * ratio / (1 + ratio) / time_step};
}

std::array<double, 2> CompliantDrive::expected(double time_step) const {
  std::array<double, 2> place = now_.place;
  for (std::size_t c = 0; c < 2; ++c) {
    place[c] += time_step * (now_.velocity[c] + 0.5 * time_step * now_.acceleration[c]);
  }
  return place;
}

SliderGuide CompliantDrive::guide(double time_step, const DriveEnd& end) const {
  const Weights rate = weights(time_step);
  const double inertia = drive_.mass * rate.of_new;
  const double stiffness = inertia * rate.of_new + drive_.damping * rate.of_new + drive_.stiffness;
  SliderGuide guide{end.place, expected(time_step), {}};
  for (std::size_t c = 0; c < 2; ++c) {
    if (!along_[c]) {
      guide.expected[c] = end.place[c];
      continue;
    }
    // Contribution of past steps to the new velocity and acceleration.
    const double velocity =
        -rate.of_now * now_.place[c] + (before_ ? rate.of_before * before_->place[c] : 0.0);
    const double acceleration =
        -rate.of_now * now_.velocity[c] + (before_ ? rate.of_before * before_->velocity[c] : 0.0);
    guide.place[c] =
        (drive_.stiffness * end.place[c] + drive_.damping * (end.velocity[c] - velocity) -
         inertia * velocity - drive_.mass * acceleration) /
        stiffness;
    guide.compliance[c] = 1 / (meshed_share_ * stiffness);
  }
  return guide;
}

double CompliantDrive::surprise(double time_step, const std::array<double, 2>& place) const {
  const auto expected = this->expected(time_step);
  double square = 0;
  for (std::size_t c = 0; c < 2; ++c) {
    square += along_[c] ? std::pow(place[c] - expected[c], 2) : 0.0;
  }
  return std::sqrt(square);
}

void CompliantDrive::accept(double time_step, const std::array<double, 2>& place,
                            const DriveEnd& end) {
  const Weights rate = weights(time_step);
  Instant next{place, end.velocity, {}};
  for (std::size_t c = 0; c < 2; ++c) {
    if (along_[c]) {
      const auto change = [&](double to, double from, double earlier) {
        return rate.of_new * to - rate.of_now * from + rate.of_before * earlier;
      };
      next.velocity[c] = change(place[c], now_.place[c], before_ ? before_->place[c] : 0.0);
      next.acceleration[c] =
          change(next.velocity[c], now_.velocity[c], before_ ? before_->velocity[c] : 0.0);
    }
  }
  before_ = now_;
  now_ = next;
  last_step_ = time_step;
}

std::array<double, 2> CompliantDrive::force(const DriveEnd& end) const {
  std::array<double, 2> force{};
  for (std::size_t c = 0; c < 2; ++c) {
    if (along_[c]) {
      force[c] = drive_.stiffness * (end.place[c] - now_.place[c]) +
                 drive_.damping * (end.velocity[c] - now_.velocity[c]);
    }
  }
  return force;
}

} // namespace ionskin::mechanics
