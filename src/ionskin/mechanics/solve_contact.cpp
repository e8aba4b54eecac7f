// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/solve_contact.hpp"

#include "ionskin/base/system/interrupt.hpp"
#include "ionskin/case/slider_motion.hpp"
#include "ionskin/mechanics/engine/contact_state.hpp"
#include "ionskin/mechanics/engine/stepped_strains.hpp"
#include "ionskin/mechanics/path/contact_box.hpp"
#include "ionskin/mechanics/path/find_footprint.hpp"
#include "ionskin/mechanics/path/steady_sliding.hpp"
#include "ionskin/mechanics/solve_stepped.hpp"
#include "ionskin/parallel/shared_progress.hpp"
#include "ionskin/parallel/task_pool.hpp"

#include <algorithm>
#include <utility>

namespace ionskin::mechanics {
namespace {

/// Variants with the chosen indices.
std::vector<ContactVariant> choose(const std::vector<ContactVariant>& variants,
                                   const std::vector<std::size_t>& chosen) {
  std::vector<ContactVariant> result;
  for (const std::size_t i : chosen) {
    result.push_back(variants[i]);
  }
  return result;
}

/// Wider footprints that some solutions need, each with the indices of the solutions that need it.
/// Each solution decides for itself, so that none depends on the others.
std::vector<std::pair<mesh::Footprint, std::vector<std::size_t>>>
wider_footprints(const std::vector<SteppedSolution>& solved) {
  std::vector<std::pair<mesh::Footprint, std::vector<std::size_t>>> result;
  for (std::size_t i = 0; i < solved.size(); ++i) {
    if (const auto& wider = solved[i].wider) {
      const auto same =
          std::ranges::find_if(result, [&](const auto& group) { return group.first == *wider; });
      auto& group =
          same == result.end() ? result.emplace_back(*wider, std::vector<std::size_t>{}) : *same;
      group.second.push_back(i);
    }
  }
  return result;
}

/// Finds the footprints of all variants and solves those that share a footprint together.
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
      const FoundFootprint found =
          find_footprint(input, variants[first].friction, options.threads, options.progress);
      together.footprint = found.footprint;
      for (std::size_t i = first + 1; found.shared && i < variants.size(); ++i) {
        if (input.slider.sharp() || footprint_friction(variants[i].friction) ==
                                        footprint_friction(variants[first].friction)) {
          sharing.push_back(i);
        }
      }
    }
    auto solved = solve_variants(input, choose(variants, sharing), together, timers);
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
  parallel::SharedProgress progress("mechanics", options.progress);
  auto solved = solve_stepped(input, *options.footprint, variants, options, timers, progress);
  for (auto wider = wider_footprints(solved); !wider.empty(); wider = wider_footprints(solved)) {
    for (const auto& [footprint, chosen] : wider) {
      auto again =
          solve_stepped(input, footprint, choose(variants, chosen), options, timers, progress);
      for (std::size_t i = 0; i < chosen.size(); ++i) {
        solved[chosen[i]] = std::move(again[i]);
      }
    }
  }
  std::vector<ContactSolution> solutions;
  for (SteppedSolution& solution : solved) {
    solutions.push_back(std::move(solution.contact));
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
  const MotionLeg leg = first_slide(motion_legs(input.motion, input.slider));
  const auto model = std::make_shared<const SkinModel>(
      input, find_footprint(input, input.contact.friction, options.threads).footprint,
      *contact_box(input));
  const auto direction = leg.direction();
  const double value = leg.to_level.is_force
                           ? leg.to_level.value * (model->mesh.half_model() ? 0.5 : 1.0)
                           : -leg.to_level.value;
  const SliderLoad load{leg.to_level.is_force ? LoadKind::force : LoadKind::indentation, value};
  const auto recovery =
      std::make_shared<const StrainRecovery>(model, strain_components(input), options.threads);
  std::vector<ContactState> result(arc_lengths.size());
  parallel::run_tasks(arc_lengths.size(), options.threads, [&](std::size_t i) {
    base::check_interrupt();
    const std::array<double, 2> place{leg.from[0] + arc_lengths[i] * direction[0],
                                      leg.from[1] + arc_lengths[i] * direction[1]};
    ContactProblem problem{
        {},
        model->cells.area,
        model->gap,
        laws::friction(input.contact.law, input.contact.friction, input.contact.parameters)};
    ContactCompliance(*model).at(place, problem);
    const SurfaceState steady = steady_sliding(problem, load, direction, 0);
    describe(*model, steady, problem, largest_normal_force(steady.force), steady.indentation,
             result[i]);
    SteppedStrains strains(recovery, 1);
    result[i].strain = strains.at(strains.add(place, steady.force));
  });
  return result;
}

} // namespace ionskin::mechanics
