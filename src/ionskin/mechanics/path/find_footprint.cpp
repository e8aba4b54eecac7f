// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/path/find_footprint.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/case/slider_motion.hpp"
#include "ionskin/mechanics/path/contact_reach.hpp"
#include "ionskin/mechanics/path/first_touch.hpp"
#include "ionskin/mechanics/skin/skin_model.hpp"
#include "ionskin/mesh/mesh_resolution.hpp"
#include "ionskin/parallel/shared_progress.hpp"
#include "ionskin/parallel/task_pool.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace ionskin::mechanics {
namespace {

constexpr int most_passes = 12; ///< largest number of trial footprints
constexpr double growth = 1.4;  ///< factor on a rim whose border the contact reaches [1]
/// Number of growths of a rim after which `fast_growth` applies: the first guess was far too small,
/// as where adhesion pulls over a wide gap.
constexpr int many_growths = 4;
constexpr double fast_growth = 2.5;
constexpr double least_fill = 0.6;   ///< smallest share of a rim that the contact must fill [1]
constexpr double trial_margin = 1.3; ///< rim that is tried next, over what the contact needs [1]
constexpr double margin = 1.1;       ///< rim that is accepted, over what the contact needs [1]
constexpr double grid_ratio = 1.05;  ///< ratio of successive rims that can be accepted [1]
/// Share of the remaining progress that a pass takes, as the number of passes is unknown [1].
constexpr double share_of_pass = 0.5;

/// Reach of the contact with the slider at two opposite corners of its track.
ContactReach reach_of(const Case& input, const mesh::Footprint& footprint, double friction,
                      int threads, parallel::SharedProgress& progress) {
  const MotionBox box = motion_box(input.motion, input.slider);
  const SkinModel model(input, footprint, box, mesh::MeshedPart::half_if_symmetric, threads,
                        finite_layers::SkinPurpose::outline);
  std::vector<std::array<double, 2>> centres{box.low, box.high};
  if (centres[0] == centres[1]) {
    centres.pop_back();
  }
  progress.begin_pass(centres.size(), share_of_pass);
  std::vector<ContactReach> reaches(centres.size());
  parallel::run_tasks(centres.size(), threads, [&](std::size_t i) {
    reaches[i] = hardest_reach(input, model, centres[i], friction);
    progress.finish_unit();
  });
  ContactReach reach = reaches.front();
  reach.include(reaches.back());
  return reach;
}

/// Rounds a length up to the next value of a geometric grid.
double rounded_up(double value) {
  return std::pow(grid_ratio, std::ceil(std::log(value) / std::log(grid_ratio)));
}

/// Sets the rim of a footprint along a direction, within the limit, and the half size with it.
void set_rim(mesh::Footprint& footprint, std::size_t direction, double rim,
             const mesh::Footprint& limit) {
  const double flat = limit.half_size[direction] - limit.rim[direction];
  footprint.rim[direction] = std::min(rim, limit.rim[direction]);
  footprint.half_size[direction] = flat + footprint.rim[direction];
}

/// Throws UserError: the contact reaches the edge of the skin.
/// @param limit largest footprint that the skin has room for
[[noreturn]] void refuse_edge(std::size_t direction, const mesh::Footprint& limit) {
  throw UserError(fmt::format(
      "the contact reaches the edge of the skin along {}: it needs more than the {:.3g} mm on each "
      "side of the slider's centre that the skin has along the path; move slider.start, shorten "
      "motion.stroke, lower motion.preload, or make the skin larger",
      direction == 0 ? "x" : "y", limit.half_size[direction] * 1e3));
}

/// The case on the coarse mesh on which the footprint is searched for.
Case footprint_case(const Case& input) {
  Case coarse = input;
  coarse.numerics.preset = Preset::coarse;
  coarse.numerics.mesh_refinement = std::min(0.75, input.numerics.mesh_refinement);
  return coarse;
}

/// Finds the footprint of a slider without sharp edges, for one friction coefficient.
mesh::Footprint footprint_at(const Case& input, double friction, int threads,
                             const base::ProgressCallback& callback) {
  mesh::Footprint footprint = mesh::largest_footprint(input);
  const mesh::Footprint limit = mesh::footprint_limit(input);
  const Case coarse = footprint_case(input);
  parallel::SharedProgress progress("contact footprint", callback);
  std::array<int, 2> growths{};
  std::array<double, 2> too_narrow{}; // widest rim that the contact filled; prevents cycling
  for (int pass = 0; pass < most_passes; ++pass) {
    const ContactReach reach = reach_of(coarse, footprint, friction, threads, progress);
    bool settled = true;
    std::array<double, 2> rim{};
    for (std::size_t d = 0; d < 2; ++d) {
      if (footprint.sharp(d)) {
        continue;
      }
      const double flat = footprint.half_size[d] - footprint.rim[d];
      const double element = mesh::mesh_resolution(coarse, footprint).edge_size[d];
      rim[d] = std::max(reach.extent[d] - flat, flat > 0 ? element : footprint.rim[d] / 20);
      const bool at_limit = footprint.rim[d] >= limit.rim[d] * (1 - 1e-9);
      if (reach.border[d] && !at_limit) {
        settled = false;
        too_narrow[d] = std::max(too_narrow[d], footprint.rim[d]);
        set_rim(footprint, d,
                (++growths[d] > many_growths ? fast_growth : growth) * footprint.rim[d], limit);
      } else if (reach.border[d] && mesh::ends_at_skin(input, footprint, d)) {
        refuse_edge(d, limit);
      } else if (reach.border[d] && mesh::ends_at_plan(input, footprint, d)) {
        footprint.end_sharply(d);
      } else if (trial_margin * rim[d] <= too_narrow[d]) {
        rim[d] = footprint.rim[d] / margin;
      } else if (rim[d] < least_fill * footprint.rim[d]) {
        settled = false;
        set_rim(footprint, d, trial_margin * rim[d], limit);
      }
    }
    if (settled) {
      for (std::size_t d = 0; d < 2; ++d) {
        if (!footprint.sharp(d)) {
          set_rim(footprint, d, rounded_up(margin * rim[d]), limit);
        }
      }
      progress.finish();
      return footprint;
    }
  }
  throw SolverError("the search for the area that the slider touches did not converge",
                    "raise numerics.mesh_refinement, or give slider.size closer to the contact");
}

} // namespace

double footprint_friction(double friction) {
  if (friction <= 0) {
    return 0;
  }
  double step = 0.5;
  while (step < friction) {
    step *= 2;
  }
  return step;
}

FoundFootprint find_footprint(const Case& input, double friction, int threads,
                              const base::ProgressCallback& progress) {
  require_touch(input);
  if (input.slider.sharp()) {
    return {mesh::largest_footprint(input), true};
  }
  try {
    return {footprint_at(input, footprint_friction(friction), threads, progress), true};
  } catch (const UserError&) { // the contact leaves the skin
  } catch (const SolverError&) {
  }
  return {footprint_at(input, friction, threads, progress), false};
}

std::optional<mesh::Footprint> widened_footprint(const Case& input,
                                                 const mesh::Footprint& footprint,
                                                 const ContactSolution& solution) {
  const mesh::Footprint limit = mesh::footprint_limit(input);
  mesh::Footprint wider = footprint;
  for (const SteppedInstant& instant : solution.stepped) {
    ContactReach reach;
    if (instant.state) {
      reach.include({solution.cell_lines_x, solution.cell_lines_y}, instant.state->normal_traction,
                    1);
    }
    for (std::size_t d = 0; d < 2; ++d) {
      if (reach.border[d] && !wider.sharp(d)) {
        if (mesh::ends_at_skin(input, footprint, d)) {
          refuse_edge(d, limit);
        }
        if (mesh::ends_at_plan(input, footprint, d)) {
          wider.end_sharply(d);
        } else {
          set_rim(wider, d, growth * footprint.rim[d], limit);
        }
      }
    }
  }
  return wider == footprint ? std::nullopt : std::optional(wider);
}

} // namespace ionskin::mechanics
