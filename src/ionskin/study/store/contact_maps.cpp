// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/store/contact_maps.hpp"

#include "ionskin/handover/cell_slip.hpp"
#include "ionskin/readout/slip_onset.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <utility>

namespace ionskin::study {
namespace {

/// Map of one contact state, without the slip since touchdown.
results::ContactMap map_of(std::string name, double time, const mechanics::ContactState& state) {
  results::ContactMap map{std::move(name),
                          time,
                          state.normal_traction,
                          state.tangential_traction_x,
                          state.tangential_traction_y,
                          state.slip,
                          {},
                          {}};
  for (std::size_t cell = 0; cell < state.normal_traction.size(); ++cell) {
    const double area = state.normal_traction[cell] > 0 ? 1 : 0;
    const double sticks = state.stick_reserve[cell] > 0 ? 1 : 0;
    map.slip_state.push_back(static_cast<double>(readout::slip_state(area, sticks)));
  }
  return map;
}

/// Names the states of a path in order: "touchdown_03", "onset_12", "steady_4", "lift_off_07", and
/// "2_onset_01" where a kind occurs for the second time.
class StepNames {
public:
  StepNames(const std::vector<MotionLeg>& legs, const mechanics::ContactSolution& contact)
      : legs_(legs), contact_(contact) {}

  std::string next(const mechanics::SteppedInstant& instant) {
    const std::string kind = kind_of(instant);
    if (kind != kind_) {
      kind_ = kind;
      ++runs_[kind];
      count_ = 0;
    }
    const std::string prefix = runs_[kind] == 1 ? "" : std::to_string(runs_[kind]) + "_";
    return kind == "steady" ? fmt::format("{}steady_{}", prefix, count_++)
                            : fmt::format("{}{}_{:02}", prefix, kind, ++count_);
  }

private:
  std::string kind_of(const mechanics::SteppedInstant& instant) const {
    const auto leg =
        std::partition_point(legs_.begin(), legs_.end() - 1, [&](const MotionLeg& other) {
          return other.end() < instant.time * (1 - 1e-12);
        });
    if (leg->lands()) {
      return "touchdown";
    }
    if (leg->leaves()) {
      return "lift_off";
    }
    const bool in_onset = std::ranges::any_of(contact_.stepped_onsets, [&](const auto& onset) {
      return instant.time > onset[0] && instant.time <= onset[1];
    });
    return in_onset ? "onset" : leg->slides() ? "steady" : "load_change";
  }

  const std::vector<MotionLeg>& legs_;
  const mechanics::ContactSolution& contact_;
  std::string kind_;
  std::map<std::string, int> runs_;
  int count_ = 0;
};

/// Drops the number from the name of a touchdown that is one increment, as under a flat slider.
void name_whole_touchdowns(std::vector<results::ContactMap>& maps) {
  constexpr std::string_view first = "touchdown_01", number = "_01";
  for (std::size_t i = 0; i < maps.size(); ++i) {
    std::string& name = maps[i].state;
    if (name.ends_with(first) &&
        (i + 1 == maps.size() || !maps[i + 1].state.ends_with("touchdown_02"))) {
      name.resize(name.size() - number.size());
    }
  }
}

std::vector<results::ContactMap> make_maps(const std::vector<MotionLeg>& legs,
                                           const mechanics::ContactSolution& contact) {
  std::vector<results::ContactMap> maps;
  StepNames names(legs, contact);
  // A long path has more instants than anybody looks at: maps of the first ones, then of some.
  constexpr std::size_t first = 100, others = 100;
  const std::size_t stride = contact.stepped.size() / others + 1;
  for (std::size_t i = 0; i < contact.stepped.size(); i += i < first ? 1 : stride) {
    const mechanics::SteppedInstant& instant = contact.stepped[i];
    if (instant.state) {
      maps.push_back(map_of(names.next(instant), instant.time, *instant.state));
    }
  }
  name_whole_touchdowns(maps);
  return maps;
}

} // namespace

results::ContactMaps make_contact_maps(const std::vector<MotionLeg>& legs,
                                       const mechanics::ContactSolution& contact,
                                       const handover::ContactTimeline& timeline) {
  std::vector<results::ContactMap> maps = make_maps(legs, contact);
  std::vector<double> instants;
  for (const results::ContactMap& map : maps) {
    instants.push_back(map.time);
  }
  auto slip = handover::slip_since_landing(timeline, contact, instants);
  for (std::size_t i = 0; i < maps.size(); ++i) {
    maps[i].slip_since_landing = std::move(slip[i]);
  }
  return {contact.cell_lines_x, contact.cell_lines_y, std::move(maps)};
}

} // namespace ionskin::study
