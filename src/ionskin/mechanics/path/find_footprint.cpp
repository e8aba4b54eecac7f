// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/path/find_footprint.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/base/system/interrupt.hpp"
#include "ionskin/case/slider_motion.hpp"
#include "ionskin/mechanics/path/first_touch.hpp"
#include "ionskin/mechanics/path/steady_sliding.hpp"
#include "ionskin/mechanics/skin/skin_model.hpp"
#include "ionskin/mechanics/surface/contact_solver.hpp"
#include "ionskin/mesh/mesh_resolution.hpp"
#include "ionskin/parallel/shared_progress.hpp"
#include "ionskin/parallel/task_pool.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace ionskin::mechanics {
namespace {

constexpr int most_passes = 12;
constexpr double growth = 1.4;
/// After so many growths the guess was far too small: adhesion pulls over a wide gap.
constexpr int many_growths = 4;
constexpr double fast_growth = 2.5;
constexpr double least_fill = 0.6;   ///< of the rim by the contact, before it is accepted
constexpr double trial_margin = 1.3; ///< of a rim that is tried next
constexpr double margin = 1.1;       ///< of the rim that is accepted
constexpr double grid_ratio = 1.05;
constexpr double share_of_pass = 0.5; ///< of the progress that is left; how many follow is unknown

/// How far from the slider's centre any cell carries force, along x and y, and whether cells at the
/// border do.
struct Reach {
  std::array<double, 2> extent{};
  std::array<bool, 2> border{};
};

void extend(Reach& reach, const ContactCells& cells, const CellVector& force) {
  const std::array<const std::vector<double>*, 2> lines{&cells.lines_x, &cells.lines_y};
  for (std::size_t cell = 0; cell < cells.count(); ++cell) {
    if (force[3 * cell] == 0) {
      continue;
    }
    const std::array<std::size_t, 2> at{cell % cells.columns(), cell / cells.columns()};
    for (std::size_t d = 0; d < 2; ++d) {
      const double low = -(*lines[d])[at[d]], high = (*lines[d])[at[d] + 1];
      const double half_size = -lines[d]->front();
      reach.extent[d] = std::max({reach.extent[d], low, high});
      reach.border[d] = reach.border[d] || std::max(low, high) >= half_size * (1 - 1e-9);
    }
  }
}

/// Loads that press hardest, of the meshed part.
std::vector<SliderLoad> heaviest_loads(const Case& input, bool half_model) {
  const mesh::HeaviestLoad heaviest = mesh::heaviest_load(input);
  std::vector<SliderLoad> loads;
  if (heaviest.indentation > 0) {
    loads.push_back({LoadKind::indentation, heaviest.indentation});
  }
  if (heaviest.force > 0) {
    loads.push_back({LoadKind::force, heaviest.force / (half_model ? 2 : 1)});
  }
  return loads;
}

/// Directions of the slides; of a path with many, some that stand for all.
std::vector<std::array<double, 2>> slide_directions(const Case& input) {
  constexpr std::size_t most = 8;
  std::set<std::array<double, 2>> directions;
  for (const MotionLeg& leg : motion_legs(input.motion, input.slider)) {
    if (leg.slides() && directions.size() <= most) {
      directions.insert(leg.direction());
    }
  }
  if (directions.size() > most) {
    const double diagonal = std::sqrt(0.5);
    return {{1, 0}, {0, 1}, {diagonal, diagonal}, {diagonal, -diagonal}};
  }
  return {directions.begin(), directions.end()};
}

/// Touchdown without history and steady sliding, to and fro, at one position.
Reach reach_at(const Case& input, const SkinModel& model, const std::array<double, 2>& centre,
               double friction) {
  base::check_interrupt();
  ContactProblem problem{{},
                         model.cells.area,
                         model.gap,
                         laws::friction(input.contact.law, friction, input.contact.parameters)};
  ContactCompliance(model).at(centre, problem.compliance);
  const CellVector none(3 * model.cells.count(), 0.0);
  Reach reach;
  for (const SliderLoad& load : heaviest_loads(input, model.mesh.half_model())) {
    extend(reach, model.cells, solve_contact_step(problem, {load, {0, 0}, 0, none}, none).force);
    if (problem.friction.adhesion.pulls()) {
      continue; // what slides beyond the border is found on the path, and gets a wider one
    }
    for (const auto& way : slide_directions(input)) {
      for (const double sign : {1.0, -1.0}) {
        extend(reach, model.cells,
               steady_sliding(problem, load, {sign * way[0], sign * way[1]}, 0).force);
      }
    }
  }
  return reach;
}

/// Over two corners of the track.
Reach reach_of(const Case& input, const mesh::Footprint& footprint, double friction, int threads,
               parallel::SharedProgress& progress) {
  const MotionBox box = motion_box(input.motion, input.slider);
  const SkinModel model(input, footprint, box, mesh::MeshedPart::half_if_symmetric, threads,
                        finite_layers::SkinPurpose::outline);
  std::vector<std::array<double, 2>> centres{box.low, box.high};
  if (centres[0] == centres[1]) {
    centres.pop_back();
  }
  progress.begin_pass(centres.size(), share_of_pass);
  std::vector<Reach> reaches(centres.size());
  parallel::run_tasks(centres.size(), threads, [&](std::size_t i) {
    reaches[i] = reach_at(input, model, centres[i], friction);
    progress.finish_unit();
  });
  Reach reach = reaches.front();
  for (std::size_t d = 0; d < 2; ++d) {
    reach.extent[d] = std::max(reach.extent[d], reaches.back().extent[d]);
    reach.border[d] = reach.border[d] || reaches.back().border[d];
  }
  return reach;
}

/// Next larger value of a geometric grid.
double rounded_up(double value) {
  return std::pow(grid_ratio, std::ceil(std::log(value) / std::log(grid_ratio)));
}

void set_rim(mesh::Footprint& footprint, std::size_t direction, double rim,
             const mesh::Footprint& limit) {
  const double flat = limit.half_size[direction] - limit.rim[direction];
  footprint.rim[direction] = std::min(rim, limit.rim[direction]);
  footprint.half_size[direction] = flat + footprint.rim[direction];
}

/// Whether a state carries force in the outermost cells, along x and y.
std::array<bool, 2> border_touched(const ContactState& state, std::size_t columns,
                                   bool half_model) {
  const std::vector<double>& traction = state.normal_traction;
  const std::size_t rows = traction.size() / columns;
  std::array<bool, 2> touched{};
  const auto loaded = [&](std::size_t cell) { return traction[cell] != 0; };
  for (std::size_t j = 0; j < rows; ++j) {
    touched[0] = touched[0] || loaded(columns * j) || loaded(columns * (j + 1) - 1);
  }
  for (std::size_t i = 0; i < columns; ++i) {
    touched[1] = touched[1] || loaded(i) || (!half_model && loaded(columns * (rows - 1) + i));
  }
  return touched;
}

[[noreturn]] void refuse_edge(std::size_t direction) {
  throw UserError(fmt::format("the contact reaches the edge of the skin along {}: {}",
                              direction == 0 ? "x" : "y", remedy_of_edge));
}

/// Of a slider that is not sharp.
mesh::Footprint footprint_at(const Case& input, double friction, int threads,
                             const base::ProgressCallback& callback) {
  mesh::Footprint footprint = mesh::largest_footprint(input);
  const mesh::Footprint limit = mesh::footprint_limit(input);
  const Case coarse = footprint_case(input);
  parallel::SharedProgress progress("contact footprint", callback);
  std::array<int, 2> growths{};
  std::array<double, 2> too_narrow{}; // the contact reached them: with few cells, rims could cycle
  for (int pass = 0; pass < most_passes; ++pass) {
    const Reach reach = reach_of(coarse, footprint, friction, threads, progress);
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
        refuse_edge(d);
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
  throw SolverError("the footprint of the slider was not found",
                    "raise numerics.mesh_refinement, or give slider.size closer to the contact");
}

} // namespace

Case footprint_case(const Case& input) {
  Case coarse = input;
  coarse.numerics.preset = Preset::coarse;
  coarse.numerics.mesh_refinement = std::min(0.75, input.numerics.mesh_refinement);
  return coarse;
}

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

std::optional<mesh::Footprint> find_common_footprint(const Case& input, double friction,
                                                     int threads,
                                                     const base::ProgressCallback& progress) {
  const mesh::Footprint largest = mesh::largest_footprint(input);
  require_touch(input, largest);
  if (input.slider.sharp()) {
    return largest;
  }
  try {
    return footprint_at(input, footprint_friction(friction), threads, progress);
  } catch (const UserError&) { // the contact leaves the skin
  } catch (const SolverError&) {
  }
  return std::nullopt;
}

mesh::Footprint find_footprint(const Case& input, double friction, int threads,
                               const base::ProgressCallback& progress) {
  const auto common = find_common_footprint(input, friction, threads, progress);
  return common ? *common : footprint_at(input, friction, threads, progress);
}

std::optional<mesh::Footprint> widened_footprint(const Case& input,
                                                 const mesh::Footprint& footprint,
                                                 const ContactSolution& solution) {
  const mesh::Footprint limit = mesh::footprint_limit(input);
  mesh::Footprint wider = footprint;
  const auto widen = [&](const SharedState& state) {
    if (!state) {
      return;
    }
    const auto touched =
        border_touched(*state, solution.cell_lines_x.size() - 1, solution.mesh.half_model());
    for (std::size_t d = 0; d < 2; ++d) {
      if (touched[d] && !footprint.sharp(d)) {
        if (mesh::ends_at_skin(input, footprint, d)) {
          refuse_edge(d);
        }
        set_rim(wider, d, growth * footprint.rim[d], limit);
      }
    }
  };
  for (const SteppedInstant& instant : solution.stepped) {
    widen(instant.state);
  }
  return wider.half_size == footprint.half_size ? std::nullopt : std::optional(wider);
}

} // namespace ionskin::mechanics
