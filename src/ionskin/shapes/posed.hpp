// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/shapes/shape.hpp"

namespace ionskin::shapes {

/// The rectangle along the axes of the skin that holds a body in a pose and in all that it turns
/// to, about its centre [m].
std::array<double, 2> posed_size(const Shape& body, const Plan& plan, const Pose& pose,
                                 const ChangingAngles& changing);

/// A body in a pose: tilted by little, so that a slope is added to its height, and then turned,
/// docs/model.md (77). Places and plans that its members take are along the axes of the skin; it
/// keeps the body's own plan, of which the heights must outlive it.
class Posed final : public Shape {
public:
  Posed(std::unique_ptr<const Shape> body, const Plan& plan, const Pose& pose,
        const ChangingAngles& changing);

  double height(const Plan& plan, double x, double y) const override;
  double lowest(const Plan& plan) const override;
  bool sharp() const override;
  std::array<double, 2> flat_half_size(const Plan& plan) const override;
  std::array<bool, 2> symmetric(const Plan& plan) const override;
  double border(const Plan& plan, const Pressing& pressing, std::size_t direction) const override;
  std::optional<std::array<double, 2>> whole_plan() const override { return body_->whole_plan(); }
  std::vector<Misfit> misfits(const Plan&) const override { return body_->misfits(plan_); }

private:
  bool even() const;
  std::size_t own_direction(std::size_t direction) const;

  std::unique_ptr<const Shape> body_;
  Plan plan_;
  ChangingAngles changing_; ///< of what the body looks like
  bool spins_;
  std::array<double, 2> slope_;  ///< along the body's axes
  std::array<double, 2> x_axis_; ///< of the body, along those of the skin
};

} // namespace ionskin::shapes
