// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/mechanics/slider/turning_underside.hpp"
#include "ionskin/mechanics/surface/contact_newton.hpp"
#include "ionskin/mechanics/surface/contact_solver.hpp"

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace ionskin::mechanics {

/// Motion of a slider in a step in which it may yield to the tangential force of the skin, as on a
/// drive.
struct SliderGuide {
  std::array<double, 2> place{};      ///< of its centre at the end, without that force [m]
  std::array<double, 2> expected{};   ///< estimate of its centre at the end, with that force [m]
  std::array<double, 2> compliance{}; ///< along x and y, to the sum of the cells' forces [m/N]
};

/// Sets the compliance of a problem to that between skin and slider.
/// @param place centre of the slider [m]
using ComplianceAt =
    std::function<void(const std::array<double, 2>& place, ContactProblem& problem)>;

/// Displacement of the cells by other sliders, [3 cells] [m].
/// @param time since the begin of the cycle [s]
/// @param place centre of the slider whose cells are displaced [m]
using MovedByOthers = std::function<CellVector(double time, const std::array<double, 2>& place)>;

/// Contact of a slider with the skin, moved step by step to any position, height or force. Each
/// step solves the incremental problem of contact and friction exactly, with the compliance at the
/// end of the step. It starts from the forces of the step before and reuses the factorised
/// Jacobian.
class SlidingContact {
public:
  /// @param area,gap of the cells, as in `ContactProblem`, in the first pose [m2], [m]
  /// @param turning underside of a slider whose angles change; null where they do not
  SlidingContact(ComplianceAt compliance, std::vector<double> area, std::vector<double> gap,
                 const laws::Friction& friction,
                 std::shared_ptr<const TurningUnderside> turning = nullptr);

  /// Lets other sliders displace the skin in all later steps. Works only on a prescribed path and
  /// without adhesion.
  void let_others_move(MovedByOthers others) { others_ = std::move(others); }
  /// Sets the time at which the next step ends, since the begin of the cycle [s].
  void set_end_of_step(double time) { end_of_step_ = time; }

  /// Moves the slider. A load that does not reach the skin leaves the slider off the skin.
  /// @param time_step [s]
  /// @param place centre of the slider at the end of the step [m]
  /// @param load at the end of the step, on the meshed part; an indentation below 0 is a height
  /// @param pose at the end of the step; used only where the slider's angles change
  /// Throws SolverError when the contact has no solution; then the contact is unchanged.
  const SurfaceState& step(double time_step, const std::array<double, 2>& place,
                           const SliderLoad& load, const shapes::Pose& pose = {});

  /// Moves a slider that yields along the skin; `place()` then tells where it is. The compliance of
  /// the skin is that at the expected position. Friction with a lag follows the speed of slip to
  /// the end of the step, continued from the step before.
  /// @param time_step [s]
  /// @param load at the end of the step, on the meshed part
  /// Throws SolverError when the contact has no solution; then the contact is unchanged.
  const SurfaceState& step_yielding(double time_step, const SliderGuide& guide,
                                    const SliderLoad& load);

  /// Snapshot of what a step changes, except for the compliance and the pose.
  struct Moment {
    SurfaceState state;
    std::vector<laws::ElasticSlip> elastic_slip;
    std::vector<double> remembered_speed;
    std::optional<std::array<double, 2>> place;
    double created_energy = 0;
  };
  /// Takes a snapshot.
  Moment moment() const {
    return {state_, elastic_slip_, remembered_speed_, place_, created_energy_};
  }
  /// Restores a snapshot.
  void go_back(Moment moment);

  /// Centre of the slider [m]; only after a step.
  const std::array<double, 2>& place() const { return *place_; }
  const SurfaceState& state() const { return state_; }
  /// Displacement of the underside at each cell, as `SteppedInstant::turned`; null where the angles
  /// never change.
  std::shared_ptr<const std::vector<std::array<double, 3>>> turned() const;
  /// Contact problem at the present position.
  const ContactProblem& problem() const { return problem_; }
  bool in_contact() const; ///< true if any cell is pressed or pulled
  /// Opening up to which adhesion pulls [m]; 0 without adhesion.
  double range() const { return problem_.friction.adhesion.range; }
  /// True if the contact may have jumped in the last step, because adhesion led to a solution that
  /// Newton's method did not find near the state before.
  bool may_have_jumped() const { return may_have_jumped_; }
  /// Elastic energy less binding energy, on the meshed part [J]; 0 off the skin.
  double energy() const;
  /// Energy that friction has created so far, in cells and steps of negative dissipation, on the
  /// meshed part [J]. It is 0, apart from rounding, under a law that only dissipates.
  double created_energy() const { return created_energy_; }
  /// True if any touching cell sticks.
  bool sticks() const;
  /// Mean tangential displacement of the surface at which the whole contact slips in a given
  /// direction under the present normal forces [m]: the part still to come, `left`, and the whole
  /// of it.
  struct OnsetDistance {
    double left = 0, whole = 0;
  };
  /// Distance to full slip from the present state.
  /// @param direction of the slider's travel, a unit vector
  /// @param half_model true if the mesh covers half of the skin
  /// @param slip,time_step of the travel to come, on which friction may depend [m], [s]
  OnsetDistance onset_distance(const std::array<double, 2>& direction, bool half_model, double slip,
                               double time_step) const;

  int factorisations() const { return newton_.factorisations(); }
  int fallbacks() const { return fallbacks_; } ///< number of steps not solved from the state before

private:
  const SurfaceState& move(double time_step, const SliderGuide& guide, const SliderLoad& load,
                           const std::optional<shapes::Pose>& pose);
  void condense_at(const std::array<double, 2>& place);
  bool reaches(const SliderLoad& load) const;
  SurfaceState solve(const ContactProblem& problem, const SliderStep& step);
  SurfaceState solve_adhesive(const ContactProblem& problem, const SliderStep& step);
  void detach(const SliderStep& step);
  std::vector<double> followed(const std::vector<double>& speed, double time_step) const;
  void divide_slip();

  ComplianceAt compliance_;
  ContactProblem problem_;
  ContactNewton newton_;
  SurfaceState state_;
  std::vector<laws::ElasticSlip> elastic_slip_; ///< of each cell; empty without elastic slip
  /// Lagged speed of slip of each cell, before the present state [m/s].
  std::vector<double> remembered_speed_;
  std::optional<std::array<double, 2>> place_;
  /// Position of the slider for which `problem_` has the compliance [m].
  std::optional<std::array<double, 2>> condensed_at_;
  double created_energy_ = 0; ///< [J]
  std::shared_ptr<const TurningUnderside> turning_;
  std::optional<shapes::Pose> pose_; ///< of a slider whose angles change, after a step
  int fallbacks_ = 0;
  bool may_have_jumped_ = false;
  MovedByOthers others_; ///< null where the slider is the only one
  double end_of_step_ = 0;
};

} // namespace ionskin::mechanics
