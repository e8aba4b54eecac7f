// SPDX-License-Identifier: Apache-2.0
#include "ionskin/shapes/posed.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace ionskin::shapes {
namespace {

constexpr double rounding = 1e-9;

/// Unit vector at an angle [rad] from the x axis; exact at multiples of a quarter turn.
std::array<double, 2> unit_vector(double angle) {
  std::array<double, 2> result{std::cos(angle), std::sin(angle)};
  for (double& value : result) {
    if (std::abs(value - std::round(value)) < rounding * rounding ||
        std::abs(result[0] * result[1]) < rounding) {
      value = std::round(value);
    }
  }
  return result;
}

/// Yaw [rad] that changes the underside; 0 for an upright body of revolution.
double felt_yaw(const Shape& body, const Plan& plan, const Pose& pose) {
  return body.turns_into_itself(plan) && !pose.tilted() ? 0.0 : pose.yaw;
}

} // namespace

std::array<double, 2> posed_size(const Shape& body, const Plan& plan, const Pose& pose,
                                 const ChangingAngles& changing) {
  if (body.turns_into_itself(plan)) {
    return plan.size;
  }
  if (changing.yaw) {
    const double diagonal = std::hypot(plan.size[0], plan.size[1]);
    return {diagonal, diagonal};
  }
  const auto axis = unit_vector(pose.yaw);
  const double c = std::abs(axis[0]), s = std::abs(axis[1]);
  return {c * plan.size[0] + s * plan.size[1], s * plan.size[0] + c * plan.size[1]};
}

Posed::Posed(std::unique_ptr<const Shape> body, const Plan& plan, const Pose& pose,
             const ChangingAngles& changing)
    : body_(std::move(body)), plan_(plan), changing_(changing),
      spins_(changing.yaw), slope_{-std::tan(pose.pitch), std::tan(pose.roll)},
      x_axis_(unit_vector(felt_yaw(*body_, plan_, pose))) {
  changing_.yaw = spins_ && (!even() || !body_->turns_into_itself(plan_));
}

/// True if the body is not tilted now or later.
bool Posed::even() const {
  return slope_[0] == 0 && slope_[1] == 0 && !changing_.roll && !changing_.pitch;
}

std::size_t Posed::own_direction(std::size_t direction) const {
  return x_axis_[0] == 0 ? 1 - direction : direction;
}

double Posed::height(const Plan&, double x, double y) const {
  const double own_x = x_axis_[0] * x + x_axis_[1] * y, own_y = x_axis_[0] * y - x_axis_[1] * x;
  const double margin = 1 + rounding;
  if (std::abs(own_x) > plan_.size[0] / 2 * margin ||
      std::abs(own_y) > plan_.size[1] / 2 * margin) {
    return unreachable_gap;
  }
  const double of_body = body_->height(plan_, own_x, own_y);
  return of_body >= unreachable_gap ? of_body : of_body + slope_[0] * own_x + slope_[1] * own_y;
}

double Posed::lowest(const Plan&) const {
  return slope_[0] == 0 && slope_[1] == 0 ? body_->lowest(plan_)
                                          : body_->lowest_on_slope(plan_, slope_);
}

bool Posed::along_axes() const {
  return (x_axis_[0] == 0 || x_axis_[1] == 0) && !changing_.yaw;
}

bool Posed::sharp() const {
  return body_->sharp() && along_axes();
}

std::array<double, 2> Posed::flat_half_size(const Plan&) const {
  std::array<double, 2> result{};
  if (!along_axes()) {
    return result;
  }
  const std::array<double, 2> own = body_->flat_half_size(plan_);
  for (std::size_t d = 0; d < 2; ++d) {
    const std::size_t at = own_direction(d);
    // A tilted face is not flat any more, but its sharp edges are still sharp.
    result[d] = even() || own[at] == plan_.size[at] / 2 ? own[at] : 0.0;
  }
  return result;
}

std::array<bool, 2> Posed::symmetric(const Plan&) const {
  if (!along_axes() || spins_) { // friction of a turning slider is not symmetric
    return {false, false};
  }
  const std::array<bool, 2> own = body_->symmetric(plan_);
  const std::array<bool, 2> kept{own[0] && slope_[0] == 0 && !changing_.pitch,
                                 own[1] && slope_[1] == 0 && !changing_.roll};
  return {kept[own_direction(0)], kept[own_direction(1)]};
}

double Posed::border(const Plan& plan, const Pressing& pressing, std::size_t direction) const {
  if (even() && along_axes()) {
    Pressing own = pressing;
    own.length = x_axis_[0] == 0 ? plan_.size[1] : pressing.length;
    return body_->border(plan_, own, own_direction(direction));
  }
  if (pressing.force > 0 || changing_.any()) {
    return std::numeric_limits<double>::infinity();
  }
  // Distance up to which the undeformed skin overlaps the body, searched on a grid.
  constexpr int intervals = 256;
  const double level = lowest(plan) + pressing.indentation;
  const std::array<double, 2> step{plan.size[0] / intervals, plan.size[1] / intervals};
  double reach = 0;
  for (int j = 0; j <= intervals; ++j) {
    for (int i = 0; i <= intervals; ++i) {
      const std::array<double, 2> at{i * step[0] - plan.size[0] / 2,
                                     j * step[1] - plan.size[1] / 2};
      if (height(plan, at[0], at[1]) < level) {
        reach = std::max(reach, std::abs(at[direction]) + step[direction]);
      }
    }
  }
  return reach > 0 ? reach : std::numeric_limits<double>::infinity();
}

} // namespace ionskin::shapes
