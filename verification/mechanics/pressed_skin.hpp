// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/mechanics/skin/skin_model.hpp"
#include "ionskin/mechanics/surface/contact_solver.hpp"

#include <array>

namespace ionskin::verification {

/// The skin of a case under its slider's start, pressed and moved step by step.
class PressedSkin {
public:
  explicit PressedSkin(const Case& input);

  /// One step from the state reached so far to the indentation of the case.
  /// @param turn about z [rad]
  void advance(const std::array<double, 2>& travel, double turn = 0);

  const mechanics::ContactCells& cells() const { return model_.cells; }
  const mechanics::ContactProblem& problem() const { return problem_; }
  const mechanics::SurfaceState& state() const { return state_; }
  /// Force on the full skin: normal, along x [N].
  double force(std::size_t component) const;
  /// Moment of the forces on the full skin about the slider's centre, along x, y and z [N m].
  std::array<double, 3> moment() const;
  double contact_area() const; ///< [m2]
  double stick_area() const;   ///< [m2]
  /// Pressure in the middle of a Hertzian contact, whose square is linear in the square of the
  /// distance from there [Pa].
  double central_pressure(double contact_radius) const;

private:
  double parts() const { return model_.mesh.half_model() ? 2 : 1; }

  Slider slider_;
  mechanics::SkinModel model_;
  mechanics::ContactProblem problem_;
  mechanics::SurfaceState state_;
  double indentation_;
};

} // namespace ionskin::verification
