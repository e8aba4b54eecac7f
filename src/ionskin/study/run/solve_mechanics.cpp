// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/run/solve_mechanics.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/base/system/free_memory.hpp"
#include "ionskin/mechanics/companions.hpp"
#include "ionskin/mechanics/path/find_footprint.hpp"
#include "ionskin/parallel/shared_progress.hpp"
#include "ionskin/parallel/task_pool.hpp"
#include "ionskin/planning/resources.hpp"

#include <algorithm>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <utility>

namespace ionskin::study {
namespace {

constexpr std::string_view companion_activity = "mechanics on a coarser mesh";

using Companions = std::map<std::string, std::shared_ptr<const MechanicsRecord>>;

mechanics::PathSteps halved(mechanics::PathSteps steps) {
  steps.touchdown = std::max(1, steps.touchdown / 2);
  steps.lift_off = std::max(1, steps.lift_off / 2);
  steps.onset = std::max(1, steps.onset / 2);
  steps.onset_growth *= steps.onset_growth; // as far with half as many
  return steps;
}

/// One pass over a coarser mesh: companions of each friction coefficient.
struct Pass {
  std::vector<std::string> names;
  std::vector<mechanics::ContactSolution> solutions; ///< of each friction, of each name
};

constexpr double solved_share = 0.9; // of the progress on coarser meshes

/// @param first,share of the progress on coarser meshes
Pass solved_pass(const Case& input, const std::vector<std::string>& names,
                 const std::vector<double>& frictions, const mechanics::ContactOptions& options,
                 double first, double share) {
  std::vector<mechanics::ContactVariant> variants;
  for (const double friction : frictions) {
    for (const std::string& name : names) {
      variants.push_back(
          {friction, name == mechanics::companions::path ? halved(options.steps) : options.steps});
    }
  }
  mechanics::ContactOptions own = options;
  own.progress = [&](std::string_view activity, double fraction) {
    activity == "mechanics" ? options.progress(companion_activity, first + share * fraction)
                            : options.progress(activity, fraction);
  };
  base::Timers parts; // of the companions, which count as one stage
  return {names, mechanics::solve_variants(mechanics::companion_case(input, names.front()),
                                           variants, own, parts)};
}

std::vector<Pass> solve_passes(const Case& input, const std::vector<double>& frictions,
                               const mechanics::ContactOptions& options) {
  namespace names = mechanics::companions;
  const bool thickness = mechanics::needs_thickness_companion(input);
  const double share = thickness ? solved_share / 2 : solved_share;
  std::vector<Pass> passes;
  passes.push_back(solved_pass(input, {names::mesh, names::path}, frictions, options, 0, share));
  if (thickness) {
    passes.push_back(solved_pass(input, {names::thickness}, frictions, options, share, share));
  }
  return passes;
}

/// What the companions hold of the skin is gone when this ends.
/// @returns one entry per friction coefficient
std::vector<Companions> recorded(const Case& input, std::vector<Pass> passes, int threads,
                                 const base::ProgressCallback& callback) {
  const auto recording = base::share_of(callback, solved_share, 1 - solved_share);
  parallel::SharedProgress progress(std::string(companion_activity), recording);
  std::vector<Companions> result;
  for (Pass& pass : passes) {
    progress.add_units(pass.solutions.size());
  }
  for (Pass& pass : passes) {
    const std::vector<std::string>& names = pass.names;
    std::vector<std::shared_ptr<const MechanicsRecord>> records(pass.solutions.size());
    parallel::run_tasks(records.size(), threads, [&](std::size_t i) {
      const auto contact =
          std::make_unique<mechanics::ContactSolution>(std::move(pass.solutions[i]));
      MechanicsRecord record = make_mechanics_record(
          mechanics::companion_case(input, names[i % names.size()]), *contact);
      record.maps = {};
      records[i] = std::make_shared<const MechanicsRecord>(std::move(record));
      progress.finish_unit();
    });
    base::return_free_memory();
    result.resize(records.size() / names.size());
    for (std::size_t i = 0; i < records.size(); ++i) {
      result[i / names.size()].emplace(names[i % names.size()], std::move(records[i]));
    }
  }
  return result;
}

/// A run keeps its results where their error cannot be estimated; then `problem` says why.
template <class Work> auto attempted(std::string& problem, const Work& work) -> decltype(work()) {
  try {
    return work();
  } catch (const SolverError& error) {
    problem = error.what();
  } catch (const UserError& error) { // its mesh does not fit beside the slider
    problem = error.what();
  }
  return {};
}

/// The companions and, beside them, the solutions themselves. Their progress is told once the
/// companions are solved.
std::vector<Pass> solve_beside(const Case& input, const std::vector<double>& frictions,
                               const mechanics::ContactOptions& options, base::Timers& timers,
                               std::string& problem,
                               std::vector<mechanics::ContactSolution>& solutions) {
  mechanics::ContactOptions coarse = options, own = options;
  coarse.threads = std::max(1, options.threads / 2);
  own.threads = std::max(1, options.threads - coarse.threads);
  coarse.strain_threads = own.strain_threads = options.threads;
  std::mutex telling;
  bool companions_solved = false;
  own.progress = [&](std::string_view activity, double fraction) {
    const std::lock_guard lock(telling);
    if (companions_solved) {
      options.progress(activity, fraction);
    }
  };
  std::vector<Pass> passes;
  options.progress(companion_activity, 0.0);
  parallel::run_tasks(2, options.threads, [&](std::size_t task) {
    if (task == 0) {
      const base::Timers::Scope scope(timers, "mechanics: companion");
      passes = attempted(problem, [&] { return solve_passes(input, frictions, coarse); });
      const std::lock_guard lock(telling);
      companions_solved = true;
      options.progress("mechanics", 0.0);
    } else {
      solutions = mechanics::solve_contact(input, frictions, own, timers);
    }
  });
  return passes;
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
  std::vector<mechanics::ContactSolution> solutions;
  if (!input.numerics.error_estimate) {
    options.progress("mechanics", 0.0);
    solutions = mechanics::solve_contact(input, frictions, both, timers);
    solved_companions.resize(frictions.size());
  } else {
    std::vector<Pass> passes = solve_beside(input, frictions, both, timers, problem, solutions);
    const base::Timers::Scope scope(timers, "mechanics: companion strains");
    solved_companions = attempted(problem, [&] {
      return recorded(input, std::move(passes), options.threads, options.progress);
    });
  }
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
  const auto solved = [&] {
    return recorded(input, solve_passes(input, {input.contact.friction}, own), options.threads,
                    options.progress);
  };
  for (Companions& companions : attempted(problem, solved)) {
    record.companions = std::move(companions);
  }
}

MechanicsRecord record_mechanics(const Case& input, const SolvedMechanics& solved,
                                 const base::ProgressCallback& progress) {
  MechanicsRecord record = make_mechanics_record(input, solved.contact, progress);
  record.companions = solved.companions;
  return record;
}

} // namespace ionskin::study
