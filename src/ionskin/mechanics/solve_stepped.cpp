// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/solve_stepped.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/base/largest.hpp"
#include "ionskin/base/system/interrupt.hpp"
#include "ionskin/case/slider_motion.hpp"
#include "ionskin/mechanics/engine/adhesion_resolution.hpp"
#include "ionskin/mechanics/engine/motion_stepper.hpp"
#include "ionskin/mechanics/engine/path_thinning.hpp"
#include "ionskin/mechanics/engine/position_nodes.hpp"
#include "ionskin/mechanics/engine/stepped_strains.hpp"
#include "ionskin/mechanics/position/contact_state.hpp"
#include "ionskin/mechanics/position/interpolation_error.hpp"
#include "ionskin/mechanics/position/interpolation_nodes.hpp"
#include "ionskin/mesh/footprint.hpp"
#include "ionskin/parallel/task_pool.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <utility>

namespace ionskin::mechanics {
namespace {

/// Part of a usual slide, two fifths of the skin, between instants that are kept at least; the
/// error of straight lines between them falls with its square.
double path_resolution(const Numerics& numerics) {
  const double kept = numerics.preset == Preset::coarse ? 20
                      : numerics.preset == Preset::fine ? 80
                                                        : 40;
  return 1 / (kept * numerics.time_refinement);
}

/// The contact of a round slider may turn out to need a wider footprint, and with it another pass.
constexpr double share_of_uncertain_pass = 0.9;
constexpr std::size_t units_per_path = 10; // of the progress
constexpr double usual_slide = 0.4;        // of the skin's length
constexpr double force_share = 0.4;        // of the resolution's square
constexpr double area_tolerance = 0.02;
constexpr double steps_per_interval = 2; // that are kept at most
constexpr int most_passes = 3;           // over wider rectangles of a slider on a drive

ThinningTolerance thinning_tolerance(const Case& input, const mesh::Footprint& footprint) {
  const double resolution = path_resolution(input.numerics);
  return {force_share * resolution * resolution, area_tolerance,
          resolution * resolution * std::min(footprint.half_size[0], footprint.half_size[1]),
          resolution * usual_slide * input.skin.length, resolution * resolution};
}

/// The middle of the slide, the end of touchdown and the instants of field output, within a cycle.
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

/// What is kept of one path.
class KeptPath {
public:
  KeptPath(const PositionNodes& nodes, std::shared_ptr<SteppedStrains> strains,
           const ThinningTolerance& tolerance, ContactSolution& solution)
      : nodes_(nodes), strains_(std::move(strains)), solution_(solution),
        thinning_(tolerance, [this](PathThinning::Instant&& instant) { keep(std::move(instant)); }),
        total_slip_(nodes.model().cells.count(), 0.0) {}

  void add(const StepPoint& point, const SlidingContact& contact) {
    PathThinning::Instant instant{point.time, point.centre, point.height, point.required,   0,
                                  0,          {},           {},           point.drive_force};
    const SurfaceState& state = contact.state();
    if (point.touches) {
      largest_force_ = std::max(largest_force_, largest_normal_force(state.force));
      largest_indentation_ = std::max(largest_indentation_, std::abs(state.indentation));
      instant.force = state.force;
      instant.state = std::make_shared<ContactState>();
      describe(nodes_.model(), state, contact.problem(), largest_force_, largest_indentation_,
               *instant.state);
      if (point.time > last_time_) { // an instant that comes twice slips once
        for (std::size_t cell = 0; cell < total_slip_.size(); ++cell) {
          total_slip_[cell] += state.slip[cell];
        }
      }
      instant.state->slip = total_slip_;
      instant.area = instant.state->contact_area;
      instant.stick_share = instant.area > 0 ? instant.state->stick_area / instant.area : 0;
      solution_.worst_complementarity_residual = base::larger(
          solution_.worst_complementarity_residual, instant.state->complementarity_residual);
    }
    last_time_ = point.time;
    thinning_.add(std::move(instant));
  }
  void finish() { thinning_.finish(); }

private:
  void keep(PathThinning::Instant&& instant) {
    if (instant.state) {
      instant.state->place = strains_->add(instant.centre, std::move(instant.force));
      instant.state->source = strains_;
    }
    solution_.stepped.push_back({instant.time, instant.centre, instant.height,
                                 std::move(instant.state), instant.drive_force});
  }

  const PositionNodes& nodes_;
  std::shared_ptr<SteppedStrains> strains_;
  ContactSolution& solution_;
  PathThinning thinning_;
  std::vector<double> total_slip_;
  double largest_force_ = 0, largest_indentation_ = 0, last_time_ = -1;
};

/// Within which a slider on a drive may swing: with its footprint on the skin.
MotionBox room_on_skin(const Case& input, const mesh::Footprint& footprint) {
  constexpr double margin = 1e-3; // of the skin; the mesh needs some room at its edges
  MotionBox room{{}, {input.skin.length, input.skin.width}};
  for (std::size_t d = 0; d < 2; ++d) {
    if (d == 1 && covers_width(input)) {
      continue; // it does not yield along y
    }
    const double edge = footprint.half_size[d] + margin * room.high[d];
    room.low[d] = edge;
    room.high[d] -= edge;
  }
  return room;
}

std::optional<DriveOptions> drive_options(const Case& input, const SkinModel& model,
                                          double longest_travel) {
  constexpr double share = 0.2; // of the square of the resolution
  if (!input.motion.drive.given()) {
    return std::nullopt;
  }
  const double resolution = path_resolution(input.numerics);
  const bool along_y = !model.mesh.half_model() && !covers_width(input);
  return DriveOptions{input.motion.drive,
                      {true, along_y},
                      share * resolution * resolution,
                      longest_travel,
                      room_on_skin(input, model.mesh.footprint())};
}

/// The rectangle that a slider on a drive turned out to need, grown by some part of what it was
/// left by; empty where it stayed near enough.
std::optional<MotionBox> widened_box(const Case& input, const MotionBox& box, const MotionBox& room,
                                     const ContactSolution& solution) {
  constexpr double near_enough = 1e-3; // of the skin: there the compliance hardly changes
  constexpr double growth = 1.2;
  const std::array<double, 2> skin{input.skin.length, input.skin.width};
  MotionBox wider = box;
  for (const SteppedInstant& instant : solution.stepped) {
    for (std::size_t d = 0; d < 2 && instant.state; ++d) {
      wider.low[d] = std::min(wider.low[d], instant.centre[d]);
      wider.high[d] = std::max(wider.high[d], instant.centre[d]);
    }
  }
  bool stays = true;
  for (std::size_t d = 0; d < 2; ++d) {
    const double low = box.low[d] - wider.low[d], high = wider.high[d] - box.high[d];
    stays = stays && std::max(low, high) <= near_enough * skin[d];
    wider.low[d] = std::max(box.low[d] - growth * low, std::min(box.low[d], room.low[d]));
    wider.high[d] = std::min(box.high[d] + growth * high, std::max(box.high[d], room.high[d]));
  }
  return stays ? std::nullopt : std::optional(wider);
}

ContactSolution empty_solution(const SkinModel& model) {
  return {
      .mesh = model.mesh, .cell_lines_x = model.cells.lines_x, .cell_lines_y = model.cells.lines_y};
}

ContactSolution solve_path(const Case& input, const std::vector<MotionLeg>& legs,
                           const std::shared_ptr<const PositionNodes>& nodes,
                           const ContactVariant& variant, SharedProgress& progress) {
  const SkinModel& model = nodes->model();
  const mesh::HeaviestLoad heaviest = mesh::heaviest_load(input);
  StepperOptions options{.steps = variant.steps,
                         .longest_travel = 0,
                         .heaviest_indentation = heaviest.indentation,
                         .heaviest_force = 0,
                         .meshed_share = model.mesh.half_model() ? 0.5 : 1.0,
                         .instants = requested_instants(input, legs)};
  options.heaviest_force = heaviest.force * options.meshed_share;
  const ThinningTolerance tolerance = thinning_tolerance(input, model.mesh.footprint());
  options.longest_travel = tolerance.travel / steps_per_interval;
  options.drive = drive_options(input, model, options.longest_travel);

  ContactSolution solution = empty_solution(model);
  KeptPath kept(*nodes, std::make_shared<SteppedStrains>(nodes), tolerance, solution);
  SlidingContact contact(
      nodes->compliance(), model.cells.area, model.gap,
      laws::friction(input.contact.law, variant.friction, input.contact.parameters));
  MotionStepper stepper(contact, options, [&](const StepPoint& point, const SlidingContact& at) {
    kept.add(point, at);
  });
  kept.add({0, legs.front().from, legs.front().from_level.value, false, true, {}}, contact);
  for (std::size_t i = 0; i < legs.size(); ++i) {
    base::check_interrupt();
    stepper.follow(legs[i]);
    if ((i + 1) * units_per_path / legs.size() > i * units_per_path / legs.size()) {
      progress.finish_unit();
    }
  }
  kept.finish();
  solution.stepped_events = stepper.events();
  solution.stepped_onsets = stepper.onsets();
  solution.contact_solves = stepper.steps();
  solution.adhesion_loss = stepper.adhesion_loss() / options.meshed_share;
  solution.worst_interpolation_error = nodes->error();
  return solution;
}

/// Cases with shared positions are solved at those alone.
void require_unshared(const Case& input, const MotionBox& needed) {
  if (input.numerics.shared.given()) {
    throw SolverError(
        fmt::format("the slider on its drive leaves numerics.shared_positions: its centre goes "
                    "from {:.4g} mm to {:.4g} mm along x and from {:.4g} mm to {:.4g} mm along y",
                    needed.low[0] * 1e3, needed.high[0] * 1e3, needed.low[1] * 1e3,
                    needed.high[1] * 1e3),
        "widen numerics.shared_positions to hold that, or remove it");
  }
}

void warn_of_nodes(const Case& input, const PositionNodes& nodes, const MotionBox& box,
                   const ContactOptions& options, ContactSolution& solution) {
  const double tolerance = node_tolerance(input, box);
  if (options.nodes == 0 && nodes.error() > tolerance) {
    solution.warnings.push_back(fmt::format(
        "between the {} positions that are solved, {} along each axis at most, the strain of the "
        "path is interpolated to {:.1e} only, not to {:.1e}",
        nodes.count(), most_interpolation_nodes, nodes.error(), tolerance));
  }
}

} // namespace

std::size_t expected_positions(const Case& input) {
  const auto box = contact_box(input);
  return box ? expected_places(input, *box) : 0;
}

std::vector<ContactSolution> solve_stepped(const Case& input, const mesh::Footprint& footprint,
                                           const std::vector<ContactVariant>& variants,
                                           const ContactOptions& options, base::Timers& timers,
                                           SharedProgress& progress) {
  const auto model = std::make_shared<const SkinModel>(
      input, footprint,
      options.full_model ? mesh::MeshedPart::whole : mesh::MeshedPart::half_if_symmetric);
  const std::vector<MotionLeg> legs = motion_legs(input.motion, input.slider);
  const auto box = contact_box(input);
  std::vector<ContactSolution> solutions(variants.size(), empty_solution(*model));
  if (!box) {
    for (ContactSolution& solution : solutions) {
      for (const MotionLeg& leg : legs) {
        solution.stepped.push_back({leg.begin, leg.from, leg.from_level.value, nullptr});
      }
      solution.stepped.push_back(
          {legs.back().end(), legs.back().to, legs.back().to_level.value, nullptr});
    }
    return solutions;
  }
  progress.begin_pass(expected_positions(input) + units_per_path * variants.size(),
                      input.slider.sharp() ? 1.0 : share_of_uncertain_pass);
  std::shared_ptr<const PositionNodes> nodes;
  {
    const base::Timers::Scope scope(timers, "mechanics: factorisation");
    nodes = std::make_shared<const PositionNodes>(input, model, *box,
                                                  NodeOptions{options.threads, options.cache,
                                                              options.nodes,
                                                              loads_across_at_ends(input, *box)},
                                                  progress);
  }
  progress.add_units(units_per_path * variants.size());
  parallel::run_tasks(variants.size(), options.threads, [&](std::size_t i) {
    const base::Timers::Scope scope(timers, "mechanics: contact");
    ContactSolution checked = empty_solution(*model);
    require_resolved_adhesion(input, *nodes, *box, checked.warnings);
    solutions[i] = solve_path(input, legs, nodes, variants[i], progress);
    std::ranges::move(checked.warnings, std::back_inserter(solutions[i].warnings));
    // Each by itself, so that no solution depends on its neighbours.
    std::shared_ptr<const PositionNodes> own = nodes;
    MotionBox own_box = *box;
    const MotionBox room = room_on_skin(input, footprint);
    for (int pass = 0; pass < most_passes && input.motion.drive.given(); ++pass) {
      const auto wider = widened_box(input, own_box, room, solutions[i]);
      if (!wider) {
        break;
      }
      require_unshared(input, *wider);
      own_box = *wider;
      own = std::make_shared<const PositionNodes>(
          input, model, own_box, NodeOptions{1, options.cache, options.nodes}, progress);
      progress.add_units(units_per_path);
      solutions[i] = solve_path(input, legs, own, variants[i], progress);
    }
    warn_of_nodes(input, *own, own_box, options, solutions[i]);
  });
  progress.expect_known_units();
  return solutions;
}

} // namespace ionskin::mechanics
