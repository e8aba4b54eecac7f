// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/mechanics/contact_solver.hpp"

#include <array>
#include <vector>

namespace ionskin::mechanics {

/// A surface state with the parameter of its path, as in PathState.
struct PathPoint {
  double parameter = 0;
  SurfaceState state;
};

/// How finely the path is stepped.
struct PathSteps {
  int onset = 30;
  double onset_growth = 1.1; ///< of successive travel increments
  int lift_off = 20;
  /// Travel of the onset over the mean tangential displacement of the surface in steady sliding.
  double onset_travel_ratio = 4;
};

/// From no load to the full preload in one increment, which is exact for a flat slider: the problem
/// is then homogeneous in the indentation.
/// @param surface_before displacement that an earlier cycle left behind [m]; empty for none
SurfaceState touch_down(const ContactProblem& problem, const Motion& motion,
                        const CellVector& surface_before = {});

/// Travel after which sliding is steady to the accuracy of the path [m].
double onset_travel(const SurfaceState& touchdown, const SurfaceState& steady,
                    const std::array<double, 2>& direction, const PathSteps& steps);

/// From sticking to sliding in geometric increments of slider travel at full preload.
std::vector<PathPoint> slide_onset(const ContactProblem& problem, const Motion& motion,
                                   const std::array<double, 2>& direction,
                                   const SurfaceState& touchdown, double travel,
                                   const PathSteps& steps);

/// From a state at full preload to no load, which is solved too, in equal decrements of the
/// indentation.
std::vector<PathPoint> lift_off(const ContactProblem& problem, const Motion& motion,
                                const SurfaceState& loaded, const PathSteps& steps);

} // namespace ionskin::mechanics
