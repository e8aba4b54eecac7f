// SPDX-License-Identifier: Apache-2.0
#include "ionskin/handover/energy_balance.hpp"

#include "ionskin/handover/surface_instant.hpp"

#include <cmath>

namespace ionskin::handover {
namespace {

void set_errors(EnergyBalance& balance) {
  const double all = balance.magnitude;
  balance.relative_error = all > 0 ? std::abs(balance.missing) / all : 0;
  balance.creation_error = all > 0 ? balance.created / all : 0;
}

} // namespace

EnergyBalance energy_balance(const ContactTimeline& timeline,
                             const mechanics::ContactSolution& contact) {
  const std::vector<double> areas = cell_areas(contact);
  const double halves = contact.mesh.half_model() ? 2 : 1;
  EnergyBalance balance;
  double all_work = 0;
  SurfaceInstant before = surface_instant(timeline.at_sample(0), areas);
  for (std::size_t i = 1; i < timeline.sample_times().size(); ++i) {
    const SurfaceInstant after = surface_instant(timeline.at_sample(i), areas);
    double work = 0;
    for (std::size_t cell = 0; cell < areas.size(); ++cell) {
      const auto moved = after.moved(before, cell), slip = after.slip(before, cell);
      for (std::size_t c = 0; c < 3; ++c) {
        const double force = 0.5 * halves * (before.force[cell][c] + after.force[cell][c]);
        work += force * moved[c];
        balance.friction_work += c == 0 ? 0 : force * slip[c];
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
  const StateCombination last = timeline.at_sample(timeline.sample_times().size() - 1);
  const double stored = last.sum(&mechanics::ContactState::friction_energy);
  balance.friction_work -= stored;
  balance.elastic_energy += stored - last.sum(&mechanics::ContactState::binding_energy);
  constexpr double rounding = 1e-9; // of steps that might have jumped and did not
  const bool jumps = std::abs(contact.adhesion_loss) > rounding * all_work;
  balance.adhesion_loss = jumps ? contact.adhesion_loss : 0.0;
  balance.missing = balance.external_work - balance.friction_work - balance.elastic_energy -
                    balance.adhesion_loss;
  balance.magnitude = all_work;
  balance.created = contact.created_energy;
  set_errors(balance);
  return balance;
}

EnergyBalance energy_balance(const std::vector<EnergyBalance>& of_each) {
  EnergyBalance sum;
  for (const EnergyBalance& one : of_each) {
    for (const auto part :
         {&EnergyBalance::external_work, &EnergyBalance::friction_work,
          &EnergyBalance::elastic_energy, &EnergyBalance::adhesion_loss, &EnergyBalance::magnitude,
          &EnergyBalance::missing, &EnergyBalance::created}) {
      sum.*part += one.*part;
    }
  }
  set_errors(sum);
  return sum;
}

} // namespace ionskin::handover
