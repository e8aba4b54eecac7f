// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/surface/projected_gauss_seidel.hpp"

#include "ionskin/base/largest.hpp"

#include <algorithm>
#include <cmath>

namespace ionskin::mechanics {
namespace {

/// The projected forces of one cell, all others held.
std::array<double, 3> relaxed(const ContactProblem& problem, const SliderStep& step,
                              double indentation, const CellVector& force,
                              const CellVector& surface, int cell) {
  const std::size_t at = 3 * static_cast<std::size_t>(cell);
  const double pressing =
      force[at] - problem.opening(cell, indentation, surface) / problem.own_compliance(cell, 0);
  const double normal =
      std::isnan(pressing) ? pressing : problem.normal_response(cell, pressing).force;
  const auto slip = slip_increment(step, surface, cell);
  const double compliance = std::max(problem.own_compliance(cell, 1) + problem.common[0],
                                     problem.own_compliance(cell, 2) + problem.common[1]);
  const std::array<double, 2> trial{force[at + 1] + slip[0] / compliance,
                                    force[at + 2] + slip[1] / compliance};
  const auto tangential = problem.friction_response(cell, normal, trial, compliance, step).traction;
  return {normal, tangential[0], tangential[1]};
}

} // namespace

GaussSeidelResult projected_gauss_seidel(const ContactProblem& problem, const SliderStep& step,
                                         double indentation, CellVector& force, double tolerance,
                                         int most_sweeps) {
  CellVector surface = problem.surface_displacement(force);
  const std::size_t size = force.size();
  double scale = 0;
  for (std::size_t i = 0; i < size; i += 3) {
    scale = std::max(scale, std::abs(force[i]));
  }
  for (int sweep = 1; sweep <= most_sweeps; ++sweep) {
    double largest_change = 0;
    for (int cell = 0; cell < problem.cells(); ++cell) {
      const auto next = relaxed(problem, step, indentation, force, surface, cell);
      for (int c = 0; c < 3; ++c) {
        const int at = 3 * cell + c;
        const double change = next[c] - force[at];
        if (change == 0) {
          continue;
        }
        const double* column = problem.compliance.col(at).data();
        for (std::size_t r = 0; r < size; ++r) {
          surface[r] += change * column[r];
        }
        force[at] = next[c];
        largest_change = base::larger(largest_change, std::abs(change));
      }
      scale = std::max(scale, std::abs(next[0]));
    }
    if (largest_change <= tolerance * scale) {
      return {true, sweep};
    }
    if (std::isnan(largest_change)) { // no further sweep mends it
      return {false, sweep};
    }
  }
  return {false, most_sweeps};
}

} // namespace ionskin::mechanics
