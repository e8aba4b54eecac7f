// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/slider_motion.hpp"
#include "ionskin/mechanics/surface/contact_solver.hpp"

#include <array>
#include <vector>

namespace ionskin::mechanics {

/// How finely the path is stepped.
struct PathSteps {
  int touchdown = 20; ///< of a slider that is not flat; one increment is exact for a flat one
  int lift_off = 20;  ///< and any other change of load in place
  int onset = 30;
  double onset_growth = 1.1; ///< of successive travel increments
  /// Travel of the onset over the mean tangential displacement that the surface still has to make.
  double onset_travel_ratio = 4;
};

/// A surface state with the time since the begin of its leg [s].
struct PathPoint {
  double time = 0;
  SurfaceState state;
};

/// The load steps of one leg, all at one position.
struct LegPath {
  double begin = 0;              ///< of contact, since the begin of the leg [s]
  std::vector<PathPoint> points; ///< behind `begin`
  bool steady = false;           ///< whether the leg slides steadily behind the last point
  double joined = 0;             ///< when it does so without a trace of the onset, like `begin` [s]
  /// Steady sliding under the load of every point; only of steady legs whose load changes.
  std::vector<SurfaceState> reference;
};

/// Steps through legs of the motion at one position of the skin: from one load to another in place,
/// or from sticking to sliding. Friction makes each state depend on all steps before.
class ContactPath {
public:
  /// @param meshed_share part of the normal force that the mesh carries: 1/2 in half models
  ContactPath(const ContactProblem& problem, const PathSteps& steps, double meshed_share)
      : problem_(problem), steps_(steps), meshed_share_(meshed_share) {}

  /// Starts detached. @param surface displacement that an earlier cycle left behind [m]; empty for
  /// none
  void start_detached(const CellVector& surface = {});
  /// Starts from steady sliding along `direction`.
  void start_sliding(const SliderLevel& level, const std::array<double, 2>& direction);

  /// Steps through a leg in contact. @param direction of the leg as this position sees it
  LegPath follow(const MotionLeg& leg, const std::array<double, 2>& direction);

  const SurfaceState& state() const { return state_; }

private:
  LegPath press(const MotionLeg& leg);
  LegPath press_by_force(const MotionLeg& leg);
  LegPath slide(const MotionLeg& leg, const std::array<double, 2>& direction);
  void step(const SliderLoad& load, const std::array<double, 2>& travel, double time_step);
  /// Slider travel that brings the surface from its present state to the given one [m].
  double onset_travel(const SurfaceState& steady) const;

  const ContactProblem& problem_;
  const PathSteps& steps_;
  double meshed_share_;
  SurfaceState state_;
};

/// The load of a level on the meshed part of the skin.
SliderLoad load_of(const SliderLevel& level, double meshed_share);
/// Likewise after a fraction of the contact of a leg along which both ends are of one kind.
SliderLoad load_of(const ContactPart& part, double fraction, double meshed_share);

} // namespace ionskin::mechanics
