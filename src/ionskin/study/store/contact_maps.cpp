// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/store/contact_maps.hpp"

#include "ionskin/handover/cell_slip.hpp"
#include "ionskin/readout/slip_onset.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <utility>

namespace ionskin::study {
namespace {

/// All but what it slipped since it touches.
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

/// Names the states of the legs of a cycle and collects their maps, each state once.
class MapCollector {
public:
  explicit MapCollector(const std::vector<MotionLeg>& legs) : legs_(legs) {}

  void add_leg(std::size_t index, const mechanics::LegSolution& leg) {
    const MotionLeg& motion = legs_[index];
    if (motion.slides()) {
      const std::string prefix = numbered(slides_);
      add_path(index, leg, prefix + "onset");
      for (std::size_t i = 0; i < leg.steady.size(); ++i) {
        add(fmt::format("{}steady_{}", prefix, i), index, leg.steady[i]);
      }
    } else if (motion.lands()) {
      const std::string prefix = numbered(touchdowns_);
      add_path(index, leg, prefix + "touchdown");
      if (leg.path.size() == 2 && !maps_.empty()) {
        maps_.back().state = prefix + "touchdown"; // one increment is the whole touchdown
      }
    } else if (motion.leaves()) {
      add_path(index, leg, numbered(lifts_) + "lift_off");
    } else {
      add_path(index, leg, numbered(changes_) + "load_change");
    }
  }
  std::vector<results::ContactMap> take() { return std::move(maps_); }

private:
  /// "" for the first of its kind, "2_" for the second.
  static std::string numbered(int& count) {
    return ++count == 1 ? "" : std::to_string(count) + "_";
  }

  void add_path(std::size_t leg, const mechanics::LegSolution& solution, const std::string& name) {
    // The first state of a path is the last of the leg before.
    for (std::size_t i = 1; i < solution.path.size(); ++i) {
      add(fmt::format("{}_{:02}", name, i), leg, solution.path[i]);
    }
  }

  void add(std::string name, std::size_t leg, const mechanics::PathState& point) {
    if (!point.state || !known_.insert(point.state.get()).second) {
      return;
    }
    maps_.push_back(map_of(std::move(name), legs_[leg].begin + point.time, *point.state));
  }

  const std::vector<MotionLeg>& legs_;
  int touchdowns_ = 0, slides_ = 0, lifts_ = 0, changes_ = 0;
  std::set<const mechanics::ContactState*> known_;
  std::vector<results::ContactMap> maps_;
};

/// Names the states of a stepped path as those of legs are named: "touchdown_03", "onset_12",
/// "steady_04", "lift_off_07", and "2_onset_01" where a kind comes for the second time.
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
    return fmt::format("{}{}_{:02}", prefix, kind, ++count_);
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

std::vector<results::ContactMap> make_maps(const std::vector<MotionLeg>& legs,
                                           const mechanics::ContactSolution& contact) {
  MapCollector collector(legs);
  for (std::size_t i = 0; i < legs.size(); ++i) {
    if (!contact.legs.empty() && legs[i].touches()) {
      collector.add_leg(i, contact.legs[i]);
    }
  }
  std::vector<results::ContactMap> maps = collector.take();
  StepNames names(legs, contact);
  // A long path passes more instants than anybody looks at: the first all, of the others some.
  constexpr std::size_t first = 100, others = 100;
  const std::size_t stride = contact.stepped.size() / others + 1;
  for (std::size_t i = 0; i < contact.stepped.size(); i += i < first ? 1 : stride) {
    const mechanics::SteppedInstant& instant = contact.stepped[i];
    if (instant.state) {
      maps.push_back(map_of(names.next(instant), instant.time, *instant.state));
    }
  }
  return maps;
}

} // namespace

results::ContactMaps make_contact_maps(const std::vector<MotionLeg>& legs,
                                       const mechanics::ContactSolution& contact,
                                       const handover::ContactTimeline& timeline) {
  std::vector<results::ContactMap> maps = make_maps(legs, contact);
  std::vector<double> instants;
  for (const results::ContactMap& map : maps) {
    instants.push_back(map.parameter);
  }
  auto slip = handover::slip_since_landing(timeline, contact, instants);
  for (std::size_t i = 0; i < maps.size(); ++i) {
    maps[i].slip_since_landing = std::move(slip[i]);
  }
  return {contact.cell_lines_x, contact.cell_lines_y, std::move(maps)};
}

} // namespace ionskin::study
