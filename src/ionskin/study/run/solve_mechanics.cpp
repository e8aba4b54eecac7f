// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/run/solve_mechanics.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/mechanics/companions.hpp"
#include "ionskin/mechanics/path/find_footprint.hpp"
#include "ionskin/planning/resources.hpp"

#include <algorithm>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

namespace ionskin::study {
namespace {

constexpr std::string_view companion_activity = "mechanics on a coarser mesh";

using Companions = std::map<std::string, mechanics::ContactSolution>;

mechanics::PathSteps halved(mechanics::PathSteps steps) {
  steps.touchdown = std::max(1, steps.touchdown / 2);
  steps.lift_off = std::max(1, steps.lift_off / 2);
  steps.onset = std::max(1, steps.onset / 2);
  steps.onset_growth *= steps.onset_growth; // as far with half as many
  return steps;
}

/// Options whose solution takes up a part of the progress on coarser meshes.
mechanics::ContactOptions with_share(const mechanics::ContactOptions& options, double first,
                                     double share) {
  mechanics::ContactOptions result = options;
  result.progress = [&options, first, share](std::string_view activity, double fraction) {
    activity == "mechanics" ? options.progress(companion_activity, first + share * fraction)
                            : options.progress(activity, fraction);
  };
  return result;
}

/// One entry per friction coefficient.
std::vector<Companions> solve_companions(const Case& input, const std::vector<double>& frictions,
                                         const mechanics::ContactOptions& options) {
  base::Timers parts; // of the companions, which count as one stage
  std::vector<mechanics::ContactVariant> variants;
  for (const double friction : frictions) {
    variants.push_back({friction, options.steps});
    variants.push_back({friction, halved(options.steps)});
  }
  const bool has_second = mechanics::needs_thickness_companion(input);
  auto solutions =
      mechanics::solve_variants(mechanics::companion_case(input, mechanics::companions::mesh),
                                variants, with_share(options, 0, has_second ? 0.5 : 1), parts);
  std::vector<Companions> result(frictions.size());
  for (std::size_t i = 0; i < frictions.size(); ++i) {
    result[i].emplace(mechanics::companions::mesh, std::move(solutions[2 * i]));
    result[i].emplace(mechanics::companions::path, std::move(solutions[2 * i + 1]));
  }
  if (has_second) {
    auto finer =
        mechanics::solve_contact(mechanics::companion_case(input, mechanics::companions::thickness),
                                 frictions, with_share(options, 0.5, 0.5), parts);
    for (std::size_t i = 0; i < frictions.size(); ++i) {
      result[i].emplace(mechanics::companions::thickness, std::move(finer[i]));
    }
  }
  return result;
}

/// A run keeps its results where their error cannot be estimated; then `problem` says why.
std::vector<Companions> try_companions(const Case& input, const std::vector<double>& frictions,
                                       const mechanics::ContactOptions& options,
                                       std::string& problem) {
  try {
    return solve_companions(input, frictions, options);
  } catch (const SolverError& error) {
    problem = error.what();
  } catch (const UserError& error) { // its mesh does not fit beside the slider
    problem = error.what();
  }
  return {};
}

std::shared_ptr<const MechanicsRecord>
companion_record(const Case& input, const mechanics::ContactSolution& contact,
                 const base::ProgressCallback& progress = base::no_progress) {
  MechanicsRecord record = make_mechanics_record(input, contact, progress);
  record.maps = {};
  return std::make_shared<const MechanicsRecord>(std::move(record));
}

} // namespace

std::vector<SolvedMechanics> solve_mechanics(const Case& input,
                                             const std::vector<double>& frictions,
                                             const mechanics::ContactOptions& options,
                                             base::Timers& timers) {
  mechanics::ContactOptions both = options;
  if (!both.footprint) {
    const base::Timers::Scope scope(timers, "mechanics: footprint");
    both.footprint =
        mechanics::find_footprint(input, frictions.front(), options.threads, options.progress);
    if (!input.slider.sharp()) { // of which the mesh was a guess before
      planning::require_resources(input, options.threads, both.footprint);
    }
  }
  std::string problem;
  std::vector<Companions> solved_companions;
  if (!input.numerics.error_estimate) {
    solved_companions.resize(frictions.size());
  } else {
    const base::Timers::Scope scope(timers, "mechanics: companion");
    options.progress(companion_activity, 0.0);
    solved_companions = try_companions(input, frictions, both, problem);
  }
  options.progress("mechanics", 0.0);
  auto solutions = mechanics::solve_contact(input, frictions, both, timers);
  std::vector<SolvedMechanics> solved;
  for (std::size_t i = 0; i < frictions.size(); ++i) {
    solved.push_back({std::move(solutions[i]), {}});
    if (solved_companions.empty()) {
      solved.back().contact.warnings.push_back(
          "The error of the mechanics is not estimated: on a mesh of twice the size " + problem +
          ".");
    } else {
      solved.back().companions = std::move(solved_companions[i]);
    }
  }
  return solved;
}

void add_companions(const Case& input, const mechanics::ContactOptions& options,
                    MechanicsRecord& record) {
  mechanics::ContactOptions own = options;
  if (!own.footprint) {
    own.footprint = mechanics::find_footprint(input, input.contact.friction, options.threads);
  }
  std::string problem;
  for (const Companions& solved : try_companions(input, {input.contact.friction}, own, problem)) {
    for (const auto& [name, contact] : solved) {
      record.companions[name] = companion_record(mechanics::companion_case(input, name), contact);
    }
  }
}

MechanicsRecord record_mechanics(const Case& input, const SolvedMechanics& solved,
                                 const base::ProgressCallback& progress) {
  const double share = 1.0 / static_cast<double>(1 + solved.companions.size());
  MechanicsRecord record =
      make_mechanics_record(input, solved.contact, base::share_of(progress, 0, share));
  double done = share;
  for (const auto& [name, contact] : solved.companions) {
    record.companions[name] = companion_record(mechanics::companion_case(input, name), contact,
                                               base::share_of(progress, done, share));
    done += share;
  }
  return record;
}

} // namespace ionskin::study
