// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/surface/contact_newton.hpp"

#include "ionskin/base/largest.hpp"
#include "ionskin/mechanics/surface/contact_linearisation.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace ionskin::mechanics {
NewtonResult contact_newton(const ContactProblem& problem, const SliderStep& step,
                            CellVector& force, double& indentation, double tolerance,
                            int most_iterations) {
  const bool force_given = step.load.kind == LoadKind::force;
  Iterate iterate{force, force_given ? indentation : step.load.value};
  std::vector<CellPredictor> predictors(problem.area.size());
  for (int iteration = 0; iteration <= most_iterations; ++iteration) {
    const CellVector surface = problem.surface_displacement(iterate.force);
    double residual =
        force_given ? std::abs(total_normal_force(iterate.force) - step.load.value) : 0.0;
    double scale = 0;
    bool same_status = iteration > 0;
    std::vector<int> touching;
    for (int cell = 0; cell < problem.cells(); ++cell) {
      const CellPredictor now = predict(problem, step, iterate, surface, cell);
      same_status = same_status && now.status == predictors[cell].status;
      predictors[cell] = now;
      residual = base::larger(residual, now.residual);
      scale = std::max(scale, std::abs(iterate.force[3 * static_cast<std::size_t>(cell)]));
      if (now.status != CellStatus::separated) {
        touching.push_back(cell);
      }
    }
    if (same_status && residual <= tolerance * scale) {
      force = std::move(iterate.force);
      indentation = iterate.indentation;
      return {true, iteration};
    }
    if (!std::isfinite(residual)) {
      break;
    }
    if (touching.empty()) {
      if (force_given) {
        break;
      }
      std::fill(iterate.force.begin(), iterate.force.end(), 0.0);
      continue;
    }
    LinearSystem system(problem, step, touching);
    system.add_rows(predictors, iterate);
    system.solve(iterate);
  }
  return {false, most_iterations};
}

} // namespace ionskin::mechanics
