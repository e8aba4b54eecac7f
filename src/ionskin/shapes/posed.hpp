// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/shapes/shape.hpp"

namespace ionskin::shapes {

/// Size along the axes of the skin of the rectangle about the centre that contains a body in a
/// pose, and in every other pose to which it turns [m].
/// @param plan of the body, along its own axes
/// @param changing angles that change along the path: a changing yaw takes the diagonal
std::array<double, 2> posed_size(const Shape& body, const Plan& plan, const Pose& pose,
                                 const ChangingAngles& changing);

/// A body in a pose, docs/model.md (77): a small tilt, which adds a slope to its height, followed
/// by a turn about z. Positions, plans and directions of the member functions are along the axes of
/// the skin. The body's own plan is stored; its height map must outlive this object.
class Posed final : public Shape {
public:
  /// Puts a body into a pose.
  /// @param body the shape in the upright pose
  /// @param plan of the body, along its own axes
  /// @param changing angles that change along the path; symmetries and flat parts are reported only
  ///   if the motion keeps them
  Posed(std::unique_ptr<const Shape> body, const Plan& plan, const Pose& pose,
        const ChangingAngles& changing);

  double height(const Plan& plan, double x, double y) const override;
  double lowest(const Plan& plan) const override;
  bool sharp() const override;
  std::array<double, 2> flat_half_size(const Plan& plan) const override;
  std::array<bool, 2> symmetric(const Plan& plan) const override;
  double border(const Plan& plan, const Pressing& pressing, std::size_t direction) const override;
  bool along_axes() const override;
  std::optional<std::array<double, 2>> whole_plan() const override { return body_->whole_plan(); }
  std::vector<Misfit> misfits(const Plan&) const override { return body_->misfits(plan_); }

private:
  /// True if the body is not tilted now or later.
  bool even() const;
  /// Index of the body's axis (0 is x, 1 is y) that is parallel to an axis of the skin.
  std::size_t own_direction(std::size_t direction) const;

  std::unique_ptr<const Shape> body_;
  Plan plan_;                    ///< of the body, along its own axes
  ChangingAngles changing_;      ///< angles whose change alters the underside
  bool spins_;                   ///< true if the yaw changes, even if that alters nothing
  std::array<double, 2> slope_;  ///< of the tilt, along the body's axes [1]
  std::array<double, 2> x_axis_; ///< unit vector of the body's x axis in the axes of the skin
};

} // namespace ionskin::shapes
