// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/store/mechanics_record.hpp"

#include "ionskin/case/slider_motion.hpp"
#include "ionskin/handover/contact_signals.hpp"
#include "ionskin/handover/contact_timeline.hpp"
#include "ionskin/handover/energy_balance.hpp"
#include "ionskin/handover/handover.hpp"
#include "ionskin/readout/phases.hpp"

#include <fmt/core.h>

#include <algorithm>

#include <map>
#include <set>
#include <utility>

namespace ionskin::study {
namespace {

/// Names the states of a cycle and collects their maps, each state once.
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
    const mechanics::ContactState& state = *point.state;
    maps_.push_back({std::move(name), legs_[leg].begin + point.time, state.normal_traction,
                     state.tangential_traction_x, state.tangential_traction_y, state.slip});
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
      maps.push_back({names.next(instant), instant.time, instant.state->normal_traction,
                      instant.state->tangential_traction_x, instant.state->tangential_traction_y,
                      instant.state->slip});
    }
  }
  return maps;
}

std::vector<readout::Metric> contact_metrics(const Case& input,
                                             const mechanics::ContactSolution& contact,
                                             const handover::ContactTimeline& timeline) {
  const auto slide = timeline.at(readout::middle_of_slide(input.motion, input.slider));
  const double area = slide.contact_area();
  const handover::EnergyBalance energy = handover::energy_balance(timeline, contact);
  std::vector<readout::Metric> metrics{
      {"contact_area_slide", area, "m2"},
      {"mean_pressure_slide", area > 0 ? slide.normal_force() / area : 0.0, "Pa"},
      {"external_work", energy.external_work, "J"},
      {"friction_work", energy.friction_work, "J"},
      {"energy_balance_error", energy.relative_error, "1"}};
  if (const Slider& slider = input.slider; !slider.rigid() && slider.pad_thickness == 0) {
    const double nu = slider.poissons_ratio;
    metrics.push_back(
        {"slider_strain_slide",
         area > 0 ? slide.normal_force() / area * (1 - nu * nu) / slider.youngs_modulus : 0.0,
         "1"});
  }
  const auto pressed = timeline.at(readout::end_of_touchdown(input.motion, input.slider));
  if (!pressed.terms.empty()) {
    metrics.push_back(
        {"stick_fraction_touchdown", pressed.terms.front().state->stick_fraction, "1"});
  }
  return metrics;
}

/// The edge of a flat slider carries a line load behind which the skin may lift off, and the
/// contact begins again where a cell of the mesh does: two meshes may agree by chance. What sticks
/// is counted by cells under any slider.
std::vector<readout::Metric> contact_cell_errors(const Case& input,
                                                 const handover::ContactTimeline& timeline) {
  std::vector<readout::Metric> errors;
  const auto slide = timeline.at(readout::middle_of_slide(input.motion, input.slider));
  const double area = slide.contact_area();
  const auto flat = input.slider.flat_half_size();
  if (flat[0] > 0 && flat[1] > 0 && area > 0) {
    const double border = slide.contact_border();
    errors.push_back({"contact_area_slide", border, "m2"});
    errors.push_back({"mean_pressure_slide", slide.normal_force() * border / (area * area), "Pa"});
  }
  const auto pressed = timeline.at(readout::end_of_touchdown(input.motion, input.slider));
  if (!pressed.terms.empty()) {
    const mechanics::ContactState& state = *pressed.terms.front().state;
    if (state.contact_area > 0) {
      errors.push_back({"stick_fraction_touchdown", state.stick_border / state.contact_area, "1"});
    }
  }
  return errors;
}

/// From which the strains of a stepped path came; null when there is none.
const mechanics::StrainSource* strain_source(const mechanics::ContactSolution& contact) {
  for (const mechanics::SteppedInstant& instant : contact.stepped) {
    if (instant.state) {
      return instant.state->source.get();
    }
  }
  return nullptr;
}

/// Per electrode layer, over all states of the motion.
std::vector<double> largest_electrode_stress(const mechanics::ContactSolution& contact) {
  std::vector<double> largest;
  if (const mechanics::StrainSource* source = strain_source(contact)) {
    largest = source->largest_electrode_stress();
  }
  for (const mechanics::LegSolution& leg : contact.legs) {
    for (const auto* points : {&leg.path, &leg.steady}) {
      for (const mechanics::PathState& point : *points) {
        if (point.state) {
          const std::vector<double>& stress = point.state->electrode_stress;
          largest.resize(std::max(largest.size(), stress.size()));
          for (std::size_t i = 0; i < stress.size(); ++i) {
            largest[i] = std::max(largest[i], stress[i]);
          }
        }
      }
    }
  }
  return largest;
}

} // namespace

MechanicsRecord make_mechanics_record(const Case& input,
                                      const mechanics::ContactSolution& contact) {
  MechanicsRecord record;
  record.history = handover::build_strain_history(input, contact);
  const handover::ContactTimeline timeline(input, contact);
  const std::vector<MotionLeg> legs = motion_legs(input.motion, input.slider);
  const auto direction = slide_direction(legs);
  const handover::ContactSignals signals = handover::contact_signals(timeline, contact);
  for (int cycle = 0; cycle < input.motion.cycles; ++cycle) {
    for (std::size_t i = cycle == 0 ? 0 : 1; i < timeline.sample_times().size(); ++i) {
      const auto combination = timeline.at_sample(i);
      const auto tangential = combination.tangential_force();
      record.slider_z.push_back(combination.height);
      record.normal_force.push_back(combination.normal_force());
      record.tangential_force.push_back(tangential[0] * direction[0] +
                                        tangential[1] * direction[1]);
      record.contact_area.push_back(signals.area[i]);
      record.stick_share.push_back(signals.stick_share[i]);
      record.slip.push_back(signals.slip[i]);
      if (input.motion.drive.given()) {
        record.drive_force_x.push_back(combination.drive_force[0]);
        record.drive_force_y.push_back(combination.drive_force[1]);
      }
    }
  }
  record.join_time = timeline.join_time();
  record.onsets = timeline.onsets();
  record.maps = {contact.cell_lines_x, contact.cell_lines_y, make_maps(legs, contact)};
  record.worst_equilibrium_residual = contact.worst_equilibrium_residual;
  if (const mechanics::StrainSource* source = strain_source(contact)) {
    record.worst_equilibrium_residual = source->worst_equilibrium_residual();
  }
  record.worst_complementarity_residual = contact.worst_complementarity_residual;
  record.worst_interpolation_error = contact.worst_interpolation_error;
  record.contact_solves = contact.contact_solves;
  record.electrode_stress = largest_electrode_stress(contact);
  record.warnings = contact.warnings;
  record.metrics = contact_metrics(input, contact, timeline);
  record.cell_errors = contact_cell_errors(input, timeline);
  return record;
}

} // namespace ionskin::study
