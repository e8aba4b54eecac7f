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

/// Guide of a slider that yields to the tangential force of the skin.
struct SliderGuide {
  std::array<double, 2> place{};      ///< of its centre without that force [m]
  std::array<double, 2> expected{};   ///< about where it will be [m]
  std::array<double, 2> compliance{}; ///< yield by the sum of the cells' forces [m/N]
};

/// Sets the compliance of a problem to that between skin and slider at a place of the slider.
using ComplianceAt =
    std::function<void(const std::array<double, 2>& place, ContactProblem& problem)>;

/// Displacement of the cells by other sliders, with the slider at a place at a time since the begin
/// of the cycle [m].
using MovedByOthers = std::function<CellVector(double time, const std::array<double, 2>& place)>;

/// A slider on the skin, moved step by step to any place, height or force. Each step is the exact
/// incremental problem of contact and friction on the compliance at its end; it starts from the
/// forces of the step before and keeps their factorisation.
class SlidingContact {
public:
  /// @param area,gap of the cells, as in ContactProblem; the gap in the first pose
  /// @param turning underside of a slider whose angles change; null for one that keeps the gap
  SlidingContact(ComplianceAt compliance, std::vector<double> area, std::vector<double> gap,
                 const laws::Friction& friction,
                 std::shared_ptr<const TurningUnderside> turning = nullptr);

  /// Other sliders move the skin from now on. They need a rigid path and no adhesion.
  void let_others_move(MovedByOthers others) { others_ = std::move(others); }
  /// Sets the time at which the next step ends, since the begin of the cycle [s].
  void set_end_of_step(double time) { end_of_step_ = time; }

  /// Moves the slider. A load that does not reach the skin leaves it unloaded.
  /// @param time_step [s]
  /// @param place of the slider's centre at the end [m]
  /// @param load at the end, on the meshed part; an indentation below 0 is a height
  /// @param pose at the end, of a slider whose angles change
  /// Throws SolverError when the contact has no solution; then nothing has moved.
  const SurfaceState& step(double time_step, const std::array<double, 2>& place,
                           const SliderLoad& load, const shapes::Pose& pose = {});

  /// Moves a slider that yields along the skin; `place()` is then its place. Throws SolverError
  /// when the contact has no solution; then nothing has moved. The
  /// compliance of the skin is that of the place where it was expected, and friction that lags
  /// follows the speed of slip, continued from the step before, to the end of the step.
  const SurfaceState& step_yielding(double time_step, const SliderGuide& guide,
                                    const SliderLoad& load);

  /// State that a step changes, but for the compliance.
  struct Moment {
    SurfaceState state;
    std::vector<laws::ElasticSlip> elastic_slip;
    std::vector<double> remembered_speed;
    std::optional<std::array<double, 2>> place;
    double created_energy = 0;
  };
  Moment moment() const {
    return {state_, elastic_slip_, remembered_speed_, place_, created_energy_};
  }
  void go_back(Moment moment);

  const std::array<double, 2>& place() const { return *place_; } ///< after a step [m]
  const SurfaceState& state() const { return state_; }
  /// Underside at each cell, as ContactSolution keeps it; null where the angles never change.
  std::shared_ptr<const std::vector<std::array<double, 3>>> turned() const;
  /// Problem at the present place.
  const ContactProblem& problem() const { return problem_; }
  bool in_contact() const; ///< pressed or pulled
  /// Opening up to which adhesion pulls; 0 without [m].
  double range() const { return problem_.friction.adhesion.range; }
  /// True if the last step of a contact with adhesion may have jumped: it was not found near the
  /// state before.
  bool may_have_jumped() const { return may_have_jumped_; }
  /// Elastic less binding energy; 0 off the skin [J].
  double energy() const;
  /// Energy that friction created so far, in cells and steps of negative dissipation; 0 but for
  /// rounding under a law that only takes energy [J].
  double created_energy() const { return created_energy_; }
  /// True if a cell that touches does not slip.
  bool sticks() const;
  /// Length of the mean tangential displacement that the surface has to make before all of it
  /// slips along a direction under the present normal forces, and all of that displacement [m].
  struct OnsetDistance {
    double left = 0, whole = 0;
  };
  /// Distance to full slip from the present state.
  /// @param slip,time_step of the way to come, which friction may depend on [m], [s]
  OnsetDistance onset_distance(const std::array<double, 2>& direction, bool half_model, double slip,
                               double time_step) const;

  int factorisations() const { return newton_.factorisations(); }
  int fallbacks() const { return fallbacks_; } ///< steps not solved from the state before

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
  std::vector<laws::ElasticSlip> elastic_slip_; ///< of the cells; empty without
  std::vector<double> remembered_speed_;        ///< by friction, before the present state [m/s]
  std::optional<std::array<double, 2>> place_;
  std::optional<std::array<double, 2>> condensed_at_; ///< of the compliance
  double created_energy_ = 0;                         ///< [J]
  std::shared_ptr<const TurningUnderside> turning_;
  std::optional<shapes::Pose> pose_; ///< of a slider whose angles change, after a step
  int fallbacks_ = 0;
  bool may_have_jumped_ = false;
  MovedByOthers others_; ///< null where the slider is the only one
  double end_of_step_ = 0;
};

} // namespace ionskin::mechanics
