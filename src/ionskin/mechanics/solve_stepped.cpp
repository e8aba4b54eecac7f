// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/solve_stepped.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/base/system/interrupt.hpp"
#include "ionskin/case/slider_motion.hpp"
#include "ionskin/mechanics/engine/adhesion_resolution.hpp"
#include "ionskin/mechanics/engine/drive_room.hpp"
#include "ionskin/mechanics/engine/kept_path.hpp"
#include "ionskin/mechanics/engine/stepped_strains.hpp"
#include "ionskin/mechanics/path/contact_box.hpp"
#include "ionskin/mechanics/path/contact_reach.hpp"
#include "ionskin/mechanics/path/expected_steps.hpp"
#include "ionskin/mechanics/path/find_footprint.hpp"
#include "ionskin/mechanics/path/path_resolution.hpp"
#include "ionskin/mechanics/skin/other_sliders.hpp"
#include "ionskin/mechanics/skin/skin_reach.hpp"
#include "ionskin/mechanics/slider/fine_features.hpp"
#include "ionskin/mesh/footprint.hpp"
#include "ionskin/parallel/task_pool.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <utility>

namespace ionskin::mechanics {
namespace {

/// Share of the progress of a pass that may be followed by another pass on a wider footprint, as
/// under a round slider [1].
constexpr double share_of_uncertain_pass = 0.9;
constexpr std::size_t units_per_path = 10; ///< units of progress of one path
/// Tolerance of the forces in the thinning of a path, over the square of the path resolution [1].
constexpr double force_share = 0.4;
constexpr double area_tolerance = 0.02; ///< tolerance of areas in the thinning of a path [1]

ThinningTolerance thinning_tolerance(const Case& input, const mesh::Footprint& footprint) {
  const double resolution = path_resolution(input.numerics);
  return {force_share * resolution * resolution, area_tolerance,
          resolution * resolution * std::min(footprint.half_size[0], footprint.half_size[1]),
          longest_kept_travel(input), resolution * resolution};
}

/// Instants of a cycle that must be stored: the middle of the slide, the end of touchdown and the
/// instants of field output [s].
std::vector<double> requested_instants(const Case& input, const std::vector<MotionLeg>& legs) {
  const MotionLeg slide = whole_slide(legs);
  std::vector<double> instants{slide.begin + 0.5 * slide.duration};
  for (const double instant : input.output.fields) {
    instants.push_back(std::fmod(instant, legs.back().end()));
  }
  const auto landing = std::ranges::find_if(legs, &MotionLeg::lands);
  if (landing != legs.end()) {
    instants.push_back(landing->end());
  }
  std::ranges::sort(instants);
  return instants;
}

/// Instants between which the forces of other sliders are linear in time, ascending [s].
std::vector<double> instants_of(const std::vector<ForcePath>& others) {
  std::vector<double> instants;
  for (const ForcePath& path : others) {
    for (const ForcePath::Instant& instant : path.instants) {
      instants.push_back(instant.time);
    }
  }
  std::ranges::sort(instants);
  return instants;
}

/// Largest number of contact solutions for a slider on a drive: many times the expected number, and
/// as many as its oscillations take.
std::size_t most_tries(const Case& input) {
  constexpr double least = 5000, per_step = 50, per_period = 200, most_periods = 1e4;
  const double period = input.motion.drive.natural_period();
  const double swings =
      period > 0 ? std::min(input.motion.cycle_duration() / period, most_periods) : 0;
  const double tries =
      least + per_step * static_cast<double>(expected_steps(input).taken) + per_period * swings;
  return static_cast<std::size_t>(tries);
}

std::optional<DriveOptions> drive_options(const Case& input, const SkinModel& model,
                                          double longest_travel, const PathSteps& steps) {
  constexpr double share = 0.2; // tolerance over the square of the resolution
  if (!input.motion.drive.given()) {
    return std::nullopt;
  }
  const double resolution = path_resolution(input.numerics);
  const bool along_y = !model.mesh.half_model() && !covers_width(input);
  return DriveOptions{input.motion.drive,
                      {true, along_y},
                      share * resolution * resolution,
                      longest_travel,
                      room_on_skin(input, model.mesh.footprint()),
                      steps.most_driven > 0 ? steps.most_driven : most_tries(input)};
}

ContactSolution empty_solution(const SkinModel& model) {
  return {
      .mesh = model.mesh, .cell_lines_x = model.cells.lines_x, .cell_lines_y = model.cells.lines_y};
}

/// Steps the slider along its path with one variant of the contact, and thins the path.
ContactSolution solve_path(const Case& input, const std::vector<MotionLeg>& legs,
                           const SkinModel& model, const std::shared_ptr<SteppedStrains>& strains,
                           const ContactVariant& variant, const ContactOptions& contact_options,
                           parallel::SharedProgress& progress) {
  const mesh::HeaviestLoad heaviest = mesh::heaviest_load(input);
  StepperOptions options{.steps = variant.steps,
                         .longest_travel = 0,
                         .heaviest_indentation = heaviest.indentation,
                         .heaviest_force = 0,
                         .meshed_share = model.mesh.half_model() ? 0.5 : 1.0,
                         .instants = requested_instants(input, legs)};
  options.heaviest_force = heaviest.force * options.meshed_share;
  const ThinningTolerance tolerance = thinning_tolerance(input, model.mesh.footprint());
  options.longest_travel = longest_step_travel(input);
  options.longest_turn = longest_step_turn(input.numerics);
  options.half_diagonal =
      std::hypot(model.mesh.footprint().half_size[0], model.mesh.footprint().half_size[1]);
  options.drive = drive_options(input, model, options.longest_travel, variant.steps);

  ContactSolution solution = empty_solution(model);
  KeptPath kept(model, strains, tolerance, solution);
  ContactCompliance compliance(model);
  SlidingContact contact(
      [&](const auto& place, auto& result) { compliance.at(place, result); }, model.cells.area,
      model.gap, laws::friction(input.contact.law, variant.friction, input.contact.parameters),
      input.slider.changing.any()
          ? std::make_shared<const TurningUnderside>(input.slider, model.cells)
          : nullptr);
  if (variant.others) {
    options.others = instants_of(*variant.others);
    contact.let_others_move([&](double time, const std::array<double, 2>& place) {
      return moved_by_others(model, *variant.others, time, place);
    });
  }
  MotionStepper stepper(contact, options, [&](const StepPoint& point, const SlidingContact& at) {
    kept.add(point, at);
  });
  const auto finish = [&] {
    kept.finish();
    solution.stepped_events = stepper.events();
    solution.stepped_onsets = stepper.onsets();
    solution.contact_solves = stepper.steps();
    solution.adhesion_loss = stepper.adhesion_loss() / options.meshed_share;
    solution.created_energy = contact.created_energy() / options.meshed_share;
  };
  kept.add({0, legs.front().from, legs.front().from_level.value, false, true, {}}, contact);
  try {
    for (std::size_t i = 0; i < legs.size(); ++i) {
      base::check_interrupt();
      stepper.follow(legs[i]);
      if ((i + 1) * units_per_path / legs.size() > i * units_per_path / legs.size()) {
        progress.finish_unit();
      }
    }
  } catch (const SolverError&) {
    if (contact_options.unfinished) {
      finish();
      contact_options.unfinished(solution);
    }
    throw;
  }
  finish();
  return solution;
}

/// Adds a warning where a slider on a drive came nearer to an edge of the skin than the skin was
/// resolved for.
void warn_of_near_edges(const Case& input, const SkinModel& model, ContactSolution& contact) {
  constexpr double tolerated = 0.9; // actual reach over the expected one
  MotionBox places = model.places;
  for (const SteppedInstant& instant : contact.stepped) {
    for (std::size_t d = 0; d < 2 && instant.state; ++d) {
      places.low[d] = std::min(places.low[d], instant.centre[d]);
      places.high[d] = std::max(places.high[d], instant.centre[d]);
    }
  }
  const mesh::Footprint& footprint = model.mesh.footprint();
  const SkinWaves needed = skin_waves(input.skin, footprint, places),
                  expected = skin_waves(input.skin, footprint, model.places);
  if (needed.reach < tolerated * expected.reach ||
      needed.ends_reach < tolerated * expected.ends_reach ||
      needed.sides_reach < tolerated * expected.sides_reach) {
    contact.warnings.emplace_back(
        "The slider swings nearer to an edge of the skin than its drive lets expect: what that "
        "edge "
        "does to the strain is resolved less finely. Stiffen motion.drive, or take a larger skin.");
  }
}

/// Adds a warning where a height map has features finer than the contact cells.
void warn_of_unresolved_map(const Case& input, ContactSolution& contact) {
  double deepest = 0;
  for (const SteppedInstant& instant : contact.stepped) {
    deepest = std::max(deepest, instant.state ? instant.state->indentation : 0);
  }
  if (auto warning = warn_of_fine_features(input.slider, contact.cell_lines_x, contact.cell_lines_y,
                                           deepest)) {
    contact.warnings.push_back(std::move(*warning));
  }
}

/// Adds a warning where a height map whose plan is at an angle to the skin touches at the border of
/// its plan, as at a sharp edge: pressure peaks there, and no cells follow the border.
void warn_of_edge_of_map(const Case& input, ContactSolution& contact) {
  if (input.slider.profile_heights.height.empty()) {
    return;
  }
  const mesh::Footprint& footprint = contact.mesh.footprint();
  const auto plan = input.slider.plan();
  ContactReach reach;
  for (const SteppedInstant& instant : contact.stepped) {
    if (instant.state) {
      reach.include({contact.cell_lines_x, contact.cell_lines_y}, instant.state->normal_traction,
                    1);
    }
  }
  for (std::size_t d = 0; d < 2; ++d) {
    const bool whole = footprint.half_size[d] >= plan.size[d] / 2 * (1 - 1e-9);
    if (reach.border[d] && whole && !footprint.sharp(d)) {
      contact.warnings.emplace_back(
          "The height map touches the skin up to the border of its plan, as with a sharp edge, and "
          "slider.yaw turns this border away from the rows of contact cells: forces may be off by "
          "some per cent, and by more than their stated errors. Let the heights rise over the last "
          "cells before the border, or take a yaw of a multiple of 90 degrees.");
      return;
    }
  }
}

/// Solutions of a slider that never touches the skin.
std::vector<SteppedSolution> untouched(const std::vector<MotionLeg>& legs, ContactSolution empty,
                                       std::size_t count) {
  for (const MotionLeg& leg : legs) {
    empty.stepped.push_back({leg.begin, leg.from, leg.from_level.value, nullptr});
  }
  empty.stepped.push_back({legs.back().end(), legs.back().to, legs.back().to_level.value, nullptr});
  return std::vector<SteppedSolution>(count, {empty, std::nullopt});
}

} // namespace

std::vector<SteppedSolution> solve_stepped(const Case& input, const mesh::Footprint& footprint,
                                           const std::vector<ContactVariant>& variants,
                                           const ContactOptions& options, base::Timers& timers,
                                           parallel::SharedProgress& progress) {
  const auto part =
      options.full_model ? mesh::MeshedPart::whole : mesh::MeshedPart::half_if_symmetric;
  const std::vector<MotionLeg> legs = motion_legs(input.motion, input.slider);
  const auto box = contact_box(input);
  if (!box) {
    const mesh::SkinMesh mesh(input, footprint, part);
    const ContactCells cells = contact_cells(mesh);
    return untouched(legs,
                     {.mesh = mesh, .cell_lines_x = cells.lines_x, .cell_lines_y = cells.lines_y},
                     variants.size());
  }
  progress.begin_pass(1 + units_per_path * variants.size(),
                      input.slider.sharp() ? 1.0 : share_of_uncertain_pass);
  const int shared_threads = options.shared_threads > 0 ? options.shared_threads : options.threads;
  std::shared_ptr<const SkinModel> model;
  {
    const base::Timers::Scope scope(timers, "mechanics: skin");
    model = std::make_shared<const SkinModel>(
        input, footprint, expected_places(input, *box, footprint), part, shared_threads);
    progress.finish_unit();
  }
  const auto recovery =
      std::make_shared<const StrainRecovery>(model, strain_components(input), shared_threads);
  std::vector<SteppedSolution> solutions(variants.size(), {empty_solution(*model), std::nullopt});
  parallel::run_tasks(variants.size(), options.threads, [&](std::size_t i) {
    const base::Timers::Scope scope(timers, "mechanics: contact");
    ContactSolution& contact = solutions[i].contact;
    std::vector<std::string> warnings;
    require_resolved_adhesion(input, *model, *box, warnings);
    contact = solve_path(input, legs, *model,
                         std::make_shared<SteppedStrains>(recovery, shared_threads, options.spare),
                         variants[i], options, progress);
    std::ranges::move(warnings, std::back_inserter(contact.warnings));
    warn_of_near_edges(input, *model, contact);
    warn_of_unresolved_map(input, contact);
    warn_of_edge_of_map(input, contact);
    // Each variant decides for itself, so that no solution depends on the others.
    solutions[i].wider = widened_footprint(input, footprint, contact);
    if (solutions[i].wider) {
      contact = empty_solution(*model); // discarded, as a wider footprint follows
    }
  });
  return solutions;
}

} // namespace ionskin::mechanics
