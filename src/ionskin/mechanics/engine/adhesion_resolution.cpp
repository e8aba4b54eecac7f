// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/engine/adhesion_resolution.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/laws/friction/friction_law.hpp"
#include "ionskin/mechanics/surface/contact_problem.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace ionskin::mechanics {
namespace {

/// Largest share of its stiffness that a cell loses to adhesion [1]. Below a quarter, the pull
/// falls over a few cells at the border; near 1, cells let go one by one, each with a jump.
double softening(const ContactProblem& problem) {
  double largest = 0;
  for (int cell = 0; cell < problem.cells(); ++cell) {
    largest = std::max(largest, problem.pull_slope(cell) * problem.own_compliance(cell, 0));
  }
  return largest;
}

} // namespace

void require_resolved_adhesion(const Case& input, const SkinModel& model, const MotionBox& box,
                               std::vector<std::string>& warnings) {
  constexpr double resolved = 0.25, most = 0.8;
  const laws::Friction law =
      laws::friction(input.contact.law, input.contact.friction, input.contact.parameters);
  if (!law.adhesion.pulls()) {
    return;
  }
  ContactProblem problem{{}, model.cells.area, model.gap, law};
  ContactCompliance(model).at({0.5 * (box.low[0] + box.high[0]), 0.5 * (box.low[1] + box.high[1])},
                              problem);
  const double found = softening(problem);
  const std::string remedy =
      fmt::format("raise numerics.mesh_refinement by a factor of {:.2g}, or lower "
                  "contact.cohesive_strength to {:.3g} Pa",
                  found / resolved, law.adhesion.strength * std::sqrt(resolved / found));
  const std::string what =
      fmt::format("the mesh is too coarse for the border over which adhesion lets go: a cell loses "
                  "{:.0f} % of its stiffness to it, and should lose 25 %",
                  100 * found);
  if (found > most) {
    throw SolverError(what, remedy);
  }
  if (found > resolved) {
    warnings.push_back(what + "; to mend it, " + remedy);
  }
}

} // namespace ionskin::mechanics
