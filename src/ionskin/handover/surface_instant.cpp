// SPDX-License-Identifier: Apache-2.0
#include "ionskin/handover/surface_instant.hpp"

#include <algorithm>

namespace ionskin::handover {
namespace {

/// Smallest gap that marks a cell which the underside does not cover [m].
constexpr double far_beyond = 0.1;

} // namespace

SurfaceInstant::Vector SurfaceInstant::moved(const SurfaceInstant& before, std::size_t cell) const {
  Vector result{slider[0] - before.slider[0], slider[1] - before.slider[1],
                slider[2] - before.slider[2]};
  if (!turned.empty() && !before.turned.empty()) {
    // A cell that the underside covers or uncovers by moving along the skin does not move up or
    // down.
    const bool covered = std::min(turned[cell][0], before.turned[cell][0]) > -far_beyond;
    for (std::size_t c = covered ? 0 : 1; c < 3; ++c) {
      result[c] += turned[cell][c] - before.turned[cell][c];
    }
  }
  return result;
}

SurfaceInstant::Vector SurfaceInstant::slip(const SurfaceInstant& before, std::size_t cell) const {
  Vector result = moved(before, cell);
  for (std::size_t c = 0; c < 3; ++c) {
    result[c] -= surface[cell][c] - before.surface[cell][c];
  }
  return result;
}

std::vector<double> cell_areas(const mechanics::ContactSolution& contact) {
  std::vector<double> areas;
  for (std::size_t j = 0; j + 1 < contact.cell_lines_y.size(); ++j) {
    for (std::size_t i = 0; i + 1 < contact.cell_lines_x.size(); ++i) {
      areas.push_back((contact.cell_lines_x[i + 1] - contact.cell_lines_x[i]) *
                      (contact.cell_lines_y[j + 1] - contact.cell_lines_y[j]));
    }
  }
  return areas;
}

SurfaceInstant surface_instant(const StateCombination& combination,
                               const std::vector<double>& areas) {
  SurfaceInstant result;
  result.slider = {-combination.height, combination.centre[0], combination.centre[1]};
  result.turned = combination.turned;
  result.force.resize(areas.size());
  result.surface.resize(areas.size());
  for (const auto& [state, weight] : combination.terms) {
    for (std::size_t cell = 0; cell < areas.size(); ++cell) {
      const double share = weight * areas[cell];
      result.force[cell][0] += share * state->normal_traction[cell];
      result.force[cell][1] += share * state->tangential_traction_x[cell];
      result.force[cell][2] += share * state->tangential_traction_y[cell];
      for (std::size_t c = 0; c < 3; ++c) {
        result.surface[cell][c] += weight * state->surface[3 * cell + c];
      }
    }
  }
  return result;
}

} // namespace ionskin::handover
