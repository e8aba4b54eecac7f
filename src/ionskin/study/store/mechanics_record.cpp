// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/store/mechanics_record.hpp"

#include "ionskin/base/value_at.hpp"
#include "ionskin/case/slider_motion.hpp"
#include "ionskin/handover/contact_signals.hpp"
#include "ionskin/handover/contact_timeline.hpp"
#include "ionskin/handover/energy_balance.hpp"
#include "ionskin/handover/handover.hpp"
#include "ionskin/handover/sliders/sliders_history.hpp"
#include "ionskin/laws/friction/friction_law.hpp"
#include "ionskin/readout/phases.hpp"
#include "ionskin/study/store/contact_maps.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace ionskin::study {
namespace {

/// Scalar results of the contact of one slider.
/// @param energy energy balance of all sliders; null for all sliders but the first, which carries
/// it
std::vector<readout::Metric> contact_metrics(const Case& input,
                                             const handover::ContactTimeline& timeline,
                                             const handover::EnergyBalance* energy) {
  const auto slide = timeline.at(readout::middle_of_slide(input.motion, input.slider));
  const double area = slide.contact_area();
  std::vector<readout::Metric> metrics{
      {"contact_area_slide", area, "m2"},
      {"mean_pressure_slide", area > 0 ? slide.normal_force() / area : 0.0, "Pa"},
      {"peak_pressure_slide", slide.peak_pressure(), "Pa"}};
  if (energy != nullptr) {
    metrics.push_back({"external_work", energy->external_work, "J"});
    metrics.push_back({"friction_work", energy->friction_work, "J"});
    metrics.push_back({"energy_balance_error", energy->relative_error, "1"});
    metrics.push_back({"energy_creation_error", energy->creation_error, "1"});
  }
  if (const Slider& slider = input.slider; !slider.rigid() && slider.pad_thickness == 0) {
    const double nu = slider.poissons_ratio;
    metrics.push_back(
        {"slider_strain_slide",
         area > 0 ? slide.normal_force() / area * (1 - nu * nu) / slider.youngs_modulus : 0.0,
         "1"});
  }
  if (laws::friction_law(input.contact.law).adheres) {
    double pull = 0;
    for (std::size_t i = 0; i < timeline.sample_times().size(); ++i) {
      pull = std::max(pull, -timeline.at_sample(i).normal_force());
    }
    metrics.push_back({"pull_off_force", pull, "N"});
    if (energy != nullptr) {
      metrics.push_back({"adhesion_loss", energy->adhesion_loss, "J"});
    }
  }
  const auto pressed = timeline.at(readout::end_of_touchdown(input.motion, input.slider));
  if (!pressed.terms.empty()) {
    metrics.push_back(
        {"stick_fraction_touchdown", pressed.terms.front().state->stick_fraction, "1"});
  }
  return metrics;
}

/// Least errors of contact area, mean pressure and sticking share, from the finite size of the
/// contact cells. Under the edge of a flat slider, which carries a line load, the skin may lift off
/// further inside, and the contact begins again where a cell does, so that two meshes may agree by
/// chance; so it may where a height map ends the contact at its border. The sticking area is
/// counted by cells under any slider.
std::vector<readout::Metric> contact_cell_errors(const Case& input,
                                                 const mesh::Footprint& footprint,
                                                 const handover::ContactTimeline& timeline) {
  std::vector<readout::Metric> errors;
  const auto slide = timeline.at(readout::middle_of_slide(input.motion, input.slider));
  const double area = slide.contact_area();
  const auto flat = input.slider.flat_half_size();
  const bool edges = footprint.sharp(0) && footprint.sharp(1);
  if ((edges || (flat[0] > 0 && flat[1] > 0)) && area > 0) {
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

/// Source of the strains of the path; null where the slider never touches.
const mechanics::StrainSource* strain_source(const mechanics::ContactSolution& contact) {
  for (const mechanics::SteppedInstant& instant : contact.stepped) {
    if (instant.state) {
      return instant.state->source.get();
    }
  }
  return nullptr;
}

/// Adds the samples of all cycles to the record of a slider.
/// @param times sample instants of one cycle [s]
void add_samples(const Case& input, const mechanics::ContactSolution& contact,
                 const handover::ContactTimeline& timeline, const std::vector<double>& times,
                 SliderRecord& record) {
  const auto direction = slide_direction(motion_legs(input.motion, input.slider));
  const handover::ContactSignals signals = handover::contact_signals(timeline, contact);
  // Multiplied by the contact area below: the sticking area is linear between the instants.
  std::vector<double> stuck = signals.stick_share;
  for (std::size_t i = 0; i < stuck.size(); ++i) {
    stuck[i] *= signals.area[i];
  }
  const auto at = [&](const std::vector<double>& values, double time) {
    return base::value_at(timeline.sample_times(), values, time);
  };
  for (int cycle = 0; cycle < input.motion.cycles; ++cycle) {
    for (std::size_t i = cycle == 0 ? 0 : 1; i < times.size(); ++i) {
      const auto combination = timeline.at(times[i]);
      const auto tangential = combination.tangential_force();
      record.slider_z.push_back(combination.height);
      record.normal_force.push_back(combination.normal_force());
      record.tangential_force.push_back(tangential[0] * direction[0] +
                                        tangential[1] * direction[1]);
      record.tangential_force_x.push_back(tangential[0]);
      record.tangential_force_y.push_back(tangential[1]);
      const auto moment = combination.moment();
      record.moment_x.push_back(moment[0]);
      record.moment_y.push_back(moment[1]);
      record.moment_z.push_back(moment[2]);
      const double area = at(signals.area, times[i]);
      record.contact_area.push_back(area);
      record.stick_share.push_back(area > 0 ? std::min(1.0, at(stuck, times[i]) / area) : 0);
      record.slip.push_back(at(signals.slip, times[i]));
      if (input.motion.drive.given()) {
        record.drive_force_x.push_back(combination.drive_force[0]);
        record.drive_force_y.push_back(combination.drive_force[1]);
      }
    }
  }
}

/// Makes the record of one slider.
/// @param input case with this slider only
/// @param times sample instants of one cycle [s]
/// @param energy see `contact_metrics`
SliderRecord slider_record(const Case& input, const mechanics::ContactSolution& contact,
                           const std::vector<double>& times,
                           const handover::EnergyBalance* energy) {
  SliderRecord record;
  const handover::ContactTimeline timeline(input, contact);
  add_samples(input, contact, timeline, times, record);
  record.join_time = timeline.join_time();
  record.onsets = timeline.onsets();
  record.maps = make_contact_maps(motion_legs(input.motion, input.slider), contact, timeline);
  if (const mechanics::StrainSource* source = strain_source(contact)) {
    record.worst_equilibrium_residual = source->worst_equilibrium_residual();
    record.electrode_stress = source->largest_electrode_stress();
  }
  record.worst_complementarity_residual = contact.worst_complementarity_residual;
  record.contact_solves = contact.contact_solves;
  record.warnings = contact.warnings;
  record.metrics = contact_metrics(input, timeline, energy);
  const mesh::Footprint& footprint = contact.mesh.footprint();
  // A slider that covers the width of a skin between symmetry planes has no edge along y.
  record.sharp_edge = footprint.sharp(0) || (footprint.sharp(1) && !covers_width(input));
  record.cell_errors = contact_cell_errors(input, footprint, timeline);
  return record;
}

/// Sample instants of the first cycle of a history [s].
std::vector<double> first_cycle(const history::CoreHistory& history, int cycles) {
  const std::size_t steps = (history.time.size() - 1) / static_cast<std::size_t>(cycles);
  return {history.time.begin(), history.time.begin() + static_cast<std::ptrdiff_t>(steps) + 1};
}

} // namespace

MechanicsRecord make_mechanics_record(const Case& input, const mechanics::ContactSolution& contact,
                                      const base::ProgressCallback& progress) {
  MechanicsRecord record;
  record.history = handover::build_strain_history(input, contact, progress);
  const handover::EnergyBalance energy =
      handover::energy_balance(handover::ContactTimeline(input, contact), contact);
  static_cast<SliderRecord&>(record) =
      slider_record(input, contact, first_cycle(record.history, input.motion.cycles), &energy);
  return record;
}

MechanicsRecord make_mechanics_record(const Case& input,
                                      const std::vector<mechanics::ContactSolution>& contacts,
                                      const base::ProgressCallback& progress) {
  if (contacts.size() == 1) {
    return make_mechanics_record(input, contacts.front(), progress);
  }
  const std::vector<Case> sliders = cases_of_sliders(input);
  MechanicsRecord record;
  record.history = handover::build_sliders_history(sliders, contacts, progress);
  std::vector<handover::EnergyBalance> energies;
  for (std::size_t i = 0; i < sliders.size(); ++i) {
    energies.push_back(
        handover::energy_balance(handover::ContactTimeline(sliders[i], contacts[i]), contacts[i]));
  }
  const handover::EnergyBalance energy = handover::energy_balance(energies);
  const std::vector<double> times = first_cycle(record.history, input.motion.cycles);
  static_cast<SliderRecord&>(record) =
      slider_record(sliders.front(), contacts.front(), times, &energy);
  for (std::size_t i = 1; i < sliders.size(); ++i) {
    record.further_sliders.push_back(slider_record(sliders[i], contacts[i], times, nullptr));
  }
  return record;
}

} // namespace ionskin::study
