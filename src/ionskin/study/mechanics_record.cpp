// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/mechanics_record.hpp"

#include "ionskin/strain/contact_timeline.hpp"
#include "ionskin/strain/handover.hpp"

#include <fmt/core.h>

namespace ionskin::study {
namespace {

results::ContactMap make_map(std::string name, const mechanics::PathState& path) {
  const mechanics::ContactState& state = path.state;
  return {std::move(name),
          path.parameter,
          state.normal_traction,
          state.tangential_traction_x,
          state.tangential_traction_y,
          state.slip};
}

std::vector<results::ContactMap> make_maps(const mechanics::ContactSolution& contact) {
  std::vector<results::ContactMap> maps{make_map("touchdown", contact.touchdown)};
  for (std::size_t i = 0; i < contact.onset.size(); ++i) {
    maps.push_back(make_map(fmt::format("onset_{:02}", i + 1), contact.onset[i]));
  }
  for (std::size_t i = 0; i < contact.steady.size(); ++i) {
    maps.push_back(make_map(fmt::format("steady_{}", i), contact.steady[i]));
  }
  for (std::size_t i = 0; i < contact.lift_off.size(); ++i) {
    maps.push_back(make_map(fmt::format("lift_off_{:02}", i + 1), contact.lift_off[i]));
  }
  return maps;
}

} // namespace

MechanicsRecord make_mechanics_record(const Case& input,
                                      const mechanics::ContactSolution& contact) {
  MechanicsRecord record;
  record.history = strain::build_strain_history(input, contact);
  const strain::ContactTimeline timeline(input, contact);
  const auto& direction = input.motion.direction;
  for (int cycle = 0; cycle < input.motion.cycles; ++cycle) {
    for (std::size_t i = cycle == 0 ? 0 : 1; i < timeline.sample_times().size(); ++i) {
      const auto combination = timeline.at(timeline.sample_times()[i]);
      const auto tangential = combination.tangential_force();
      record.normal_force.push_back(combination.normal_force());
      record.tangential_force.push_back(tangential[0] * direction[0] +
                                        tangential[1] * direction[1]);
    }
  }
  record.join_time = timeline.join_time();
  record.maps = {contact.cell_lines_x, contact.cell_lines_y, make_maps(contact)};
  record.worst_equilibrium_residual = contact.worst_equilibrium_residual;
  record.worst_complementarity_residual = contact.worst_complementarity_residual;
  record.contact_solves = contact.contact_solves;
  record.warnings = contact.warnings;
  return record;
}

} // namespace ionskin::study
