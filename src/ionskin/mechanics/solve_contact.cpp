// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/solve_contact.hpp"

#include "ionskin/base/system/interrupt.hpp"
#include "ionskin/mechanics/path/contact_plan.hpp"
#include "ionskin/mechanics/path/find_footprint.hpp"
#include "ionskin/mechanics/path/position_states.hpp"
#include "ionskin/mechanics/path/steady_sliding.hpp"
#include "ionskin/mechanics/position/interpolation_error.hpp"
#include "ionskin/mechanics/position/interpolation_nodes.hpp"
#include "ionskin/mechanics/shared_positions.hpp"
#include "ionskin/mechanics/solve_stepped.hpp"
#include "ionskin/parallel/task_pool.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>

namespace ionskin::mechanics {
namespace {

/// The contact of a round slider may turn out to need a wider footprint, and with it another pass.
constexpr double share_of_uncertain_pass = 0.9;

mesh::MeshedPart whole(const ContactOptions& options) {
  return options.full_model ? mesh::MeshedPart::whole : mesh::MeshedPart::half_if_symmetric;
}

/// Few nodes to begin with: their solutions tell how many are needed.
NodeCounts first_node_counts(NodeCounts expected, std::size_t given) {
  constexpr std::size_t first_count = 4;
  for (std::size_t& count : expected) {
    count = given > 0 ? given : std::min(count, first_count);
  }
  return expected;
}

/// Nodes that each leg needs; keeps the error of those that it has.
NodeCounts needed_node_counts(const FrictionSolve& solve, double tolerance,
                              ContactSolution& solution) {
  const ContactPlan& plan = solve.plan;
  const NodeCounts present = plan.node_counts();
  NodeCounts counts = present;
  for (std::size_t leg = 0; leg < plan.legs.size(); ++leg) {
    const std::size_t first = plan.first_alike(leg);
    const std::vector<PathState>& steady = solution.legs[leg].steady;
    if (!steady.empty() && counts[first] == present[first]) {
      const InterpolationError error = interpolation_error(chebyshev_norms(steady));
      solution.worst_interpolation_error =
          std::max(solution.worst_interpolation_error, error.estimate);
      counts[first] = wanted_node_count(steady.size(), error, tolerance);
    }
  }
  for (std::size_t leg = 0; leg < plan.legs.size(); ++leg) {
    counts[leg] = counts[plan.first_alike(leg)];
  }
  return counts;
}

ContactSolution assembled(const SkinModel& model, const FrictionSolve& solve) {
  ContactSolution solution{
      .mesh = model.mesh, .cell_lines_x = model.cells.lines_x, .cell_lines_y = model.cells.lines_y};
  assemble(solve.plan, solve.pieces, solve.friction, solution);
  return solution;
}

void warn_of_interpolation(double tolerance, ContactSolution& solution) {
  if (solution.worst_interpolation_error > tolerance) {
    solution.warnings.push_back(fmt::format(
        "between the {} positions that are solved along a slide, the most there are, steady "
        "sliding is interpolated to {:.1e} of the strain only, not to {:.1e}",
        most_interpolation_nodes, solution.worst_interpolation_error, tolerance));
  }
}

std::vector<ContactSolution> solve_legs(const Case& input, const mesh::Footprint& footprint,
                                        const std::vector<ContactVariant>& variants,
                                        const ContactOptions& options, base::Timers& timers,
                                        SharedProgress& progress) {
  auto analysis = std::make_unique<base::Timers::Scope>(timers, "mechanics: analysis");
  const SkinModel model(input, footprint, whole(options));
  analysis.reset();
  base::check_interrupt();

  const NodeCounts expected = expected_node_counts(input);
  const ContactPlan first_plan = plan_contact(input, first_node_counts(expected, options.nodes));
  std::vector<FrictionSolve> solves;
  for (const ContactVariant& variant : variants) {
    solves.push_back({variant.friction, variant.steps, first_plan, first_plan.positions,
                      SolvedPieces(first_plan)});
  }
  progress.begin_pass(plan_contact(input, expected).positions.size() * (1 + variants.size()),
                      input.slider.sharp() ? 1.0 : share_of_uncertain_pass);
  const SharedSetting setting{model, options, timers, progress, input.contact};
  const double tolerance = interpolation_tolerance(input.numerics.preset);
  std::vector<ContactSolution> solutions;
  for (bool settled = false; !settled;) {
    solve_open_positions(setting, solves);
    progress.expect_known_units();
    settled = true;
    solutions.clear();
    for (FrictionSolve& solve : solves) {
      ContactSolution& solution = solutions.emplace_back(assembled(model, solve));
      solve.open.clear();
      const NodeCounts needed = needed_node_counts(solve, tolerance, solution);
      if (options.nodes == 0 && needed != solve.plan.node_counts()) {
        settled = false;
        ContactPlan plan = plan_contact(input, needed);
        solve.open = added_positions(plan, solve.plan);
        solve.pieces.extend(solve.plan, plan);
        solve.plan = std::move(plan);
      }
    }
  }
  for (ContactSolution& solution : solutions) {
    if (options.nodes == 0) {
      warn_of_interpolation(tolerance, solution);
    }
  }
  return solutions;
}

std::vector<ContactSolution> solve_on_footprint(const Case& input, const mesh::Footprint& footprint,
                                                const std::vector<ContactVariant>& variants,
                                                const ContactOptions& options, base::Timers& timers,
                                                SharedProgress& progress) {
  const auto solve = is_stepped(input) ? solve_stepped : solve_legs;
  return solve(input, footprint, variants, options, timers, progress);
}

/// Variants that share a footprint are solved together.
std::vector<ContactSolution> solve_on_own_footprints(const Case& input,
                                                     const std::vector<ContactVariant>& variants,
                                                     const ContactOptions& options,
                                                     base::Timers& timers) {
  std::vector<std::optional<ContactSolution>> solutions(variants.size());
  for (std::size_t first = 0; first < variants.size(); ++first) {
    if (solutions[first]) {
      continue;
    }
    ContactOptions together = options;
    std::vector<std::size_t> sharing{first};
    {
      const base::Timers::Scope scope(timers, "mechanics: footprint");
      together.footprint =
          find_common_footprint(input, variants[first].friction, options.threads, options.progress);
      for (std::size_t i = first + 1; together.footprint && i < variants.size(); ++i) {
        if (input.slider.sharp() || footprint_friction(variants[i].friction) ==
                                        footprint_friction(variants[first].friction)) {
          sharing.push_back(i);
        }
      }
      if (!together.footprint) {
        together.footprint =
            find_footprint(input, variants[first].friction, options.threads, options.progress);
      }
    }
    std::vector<ContactVariant> shared;
    for (const std::size_t i : sharing) {
      shared.push_back(variants[i]);
    }
    auto solved = solve_variants(input, shared, together, timers);
    for (std::size_t i = 0; i < sharing.size(); ++i) {
      solutions[sharing[i]] = std::move(solved[i]);
    }
  }
  std::vector<ContactSolution> result;
  for (auto& solution : solutions) {
    result.push_back(std::move(*solution));
  }
  return result;
}

} // namespace

std::vector<ContactSolution> solve_variants(const Case& input,
                                            const std::vector<ContactVariant>& variants,
                                            const ContactOptions& options, base::Timers& timers) {
  if (!options.footprint) {
    return solve_on_own_footprints(input, variants, options, timers);
  }
  const mesh::Footprint& footprint = *options.footprint;
  SharedProgress progress("mechanics", options.progress);
  auto solutions = solve_on_footprint(input, footprint, variants, options, timers, progress);
  for (std::size_t i = 0; i < variants.size(); ++i) {
    // Each by itself, so that no solution depends on its neighbours.
    mesh::Footprint own = footprint;
    while (const auto wider = widened_footprint(input, own, solutions[i])) {
      own = *wider;
      solutions[i] = std::move(
          solve_on_footprint(input, own, {variants[i]}, options, timers, progress).front());
    }
  }
  progress.finish();
  return solutions;
}

std::vector<ContactSolution> solve_contact(const Case& input, const std::vector<double>& frictions,
                                           const ContactOptions& options, base::Timers& timers) {
  std::vector<ContactVariant> variants;
  for (const double friction : frictions) {
    variants.push_back({friction, options.steps});
  }
  return solve_variants(input, variants, options, timers);
}

ContactSolution solve_contact(const Case& input, const ContactOptions& options,
                              base::Timers& timers) {
  return std::move(
      solve_contact(input, std::vector<double>{input.contact.friction}, options, timers).front());
}

std::vector<ContactState> solve_steady_sliding(const Case& input,
                                               const std::vector<double>& arc_lengths,
                                               const ContactOptions& options,
                                               base::Timers& timers) {
  const base::Timers::Scope scope(timers, "mechanics: steady sliding");
  const SkinModel model(input, find_footprint(input, input.contact.friction, options.threads));
  const SliderTrack track(input);
  const MotionLeg leg = first_slide(motion_legs(input.motion, input.slider));
  const SliderLoad load = load_of(leg.to_level, model.mesh.half_model() ? 0.5 : 1.0);
  std::vector<ContactState> result(arc_lengths.size());
  parallel::run_tasks(arc_lengths.size(), options.threads, [&](std::size_t i) {
    base::check_interrupt();
    const CanonicalPosition position{track.centre(arc_lengths[i]), {false, false}};
    const CondensedPosition condensed(model, position.centre, {options.cache});
    const ContactProblem problem{
        contact_compliance(model, condensed), model.cells.area, model.gap,
        laws::friction(input.contact.law, input.contact.friction, input.contact.parameters)};
    const SurfaceState steady = steady_sliding(problem, load, track.direction, 0);
    PositionStates states(model);
    states.add(result[i], steady, problem, position, largest_normal_force(steady.force),
               steady.indentation);
    states.complete(condensed);
  });
  return result;
}

} // namespace ionskin::mechanics
