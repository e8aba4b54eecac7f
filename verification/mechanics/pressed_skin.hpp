// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/mechanics/skin/skin_model.hpp"
#include "ionskin/mechanics/surface/contact_solver.hpp"

#include <array>

namespace ionskin::verification {

/// Skin of a case under its slider at the start position, pressed and moved step by step: what a
/// run solves along a path, for verification with closed-form contacts.
class PressedSkin {
public:
  /// Builds contact cells and compliance; no contact yet.
  explicit PressedSkin(const Case& input);

  /// Solves one contact step, from the last state to the indentation of the case.
  /// @param travel travel of the slider along x and y in this step [m]
  /// @param turn rotation about z in this step [rad]
  void advance(const std::array<double, 2>& travel, double turn = 0);

  const mechanics::ContactCells& cells() const { return model_.cells; }
  const mechanics::ContactProblem& problem() const { return problem_; }
  const mechanics::SurfaceState& state() const { return state_; }
  /// Force on the full skin [N].
  /// @param component 0: normal force; 1: along x
  double force(std::size_t component) const;
  /// Moment of the forces on the full skin about the slider's centre, along x, y and z [N m].
  std::array<double, 3> moment() const;
  double contact_area() const; ///< contact area on the full skin [m2]
  double stick_area() const;   ///< sticking part of the contact area [m2]
  /// Pressure in the centre of a Hertzian contact [Pa], by a linear fit of the pressure squared
  /// over the distance from the centre squared.
  /// @param contact_radius radius, or half width, of the contact [m]; cells within 0.6 of it are
  /// fitted
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
