// SPDX-License-Identifier: Apache-2.0
#include "ionskin/handover/energy_balance.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace ionskin::handover {
namespace {

using Vector = std::array<double, 3>; // normal downwards, along x, along y

/// Slider and surface at one instant.
struct Instant {
  Vector slider{};             ///< [m]
  std::vector<Vector> force;   ///< on each cell [N]
  std::vector<Vector> surface; ///< displacement of each cell [m]
};

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

Instant instant(const StateCombination& combination, const std::vector<double>& areas) {
  Instant result;
  result.slider = {std::max(0.0, -combination.height), combination.centre[0],
                   combination.centre[1]};
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

} // namespace

EnergyBalance energy_balance(const ContactTimeline& timeline,
                             const mechanics::ContactSolution& contact) {
  const std::vector<double> areas = cell_areas(contact);
  const double halves = contact.mesh.half_model() ? 2 : 1;
  EnergyBalance balance;
  double all_work = 0;
  Instant before = instant(timeline.at_sample(0), areas);
  for (std::size_t i = 1; i < timeline.sample_times().size(); ++i) {
    const Instant after = instant(timeline.at_sample(i), areas);
    double work = 0;
    for (std::size_t cell = 0; cell < areas.size(); ++cell) {
      for (std::size_t c = 0; c < 3; ++c) {
        const double force = 0.5 * halves * (before.force[cell][c] + after.force[cell][c]);
        const double moved = after.slider[c] - before.slider[c];
        const double slip = moved - (after.surface[cell][c] - before.surface[cell][c]);
        work += force * moved;
        balance.friction_work += c == 0 ? 0 : force * slip;
      }
    }
    balance.external_work += work;
    all_work += std::abs(work);
    before = after;
  }
  for (std::size_t cell = 0; cell < areas.size(); ++cell) {
    for (std::size_t c = 0; c < 3; ++c) {
      balance.elastic_energy += 0.5 * halves * before.force[cell][c] * before.surface[cell][c];
    }
  }
  const double missing = balance.external_work - balance.friction_work - balance.elastic_energy;
  balance.relative_error = all_work > 0 ? std::abs(missing) / all_work : 0;
  return balance;
}

} // namespace ionskin::handover
