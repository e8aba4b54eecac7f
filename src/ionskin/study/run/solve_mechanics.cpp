// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/run/solve_mechanics.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/base/system/free_memory.hpp"
#include "ionskin/mechanics/coarser_solutions.hpp"
#include "ionskin/mechanics/path/find_footprint.hpp"
#include "ionskin/mechanics/solve_sliders.hpp"
#include "ionskin/parallel/shared_progress.hpp"
#include "ionskin/parallel/task_pool.hpp"
#include "ionskin/planning/resources.hpp"

#include <algorithm>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <utility>

namespace ionskin::study {
namespace {

constexpr std::string_view coarser_activity = "mechanics on a coarser mesh";

using CoarserSolutions = std::map<std::string, std::shared_ptr<const MechanicsRecord>>;

mechanics::PathSteps halved(mechanics::PathSteps steps) {
  steps.touchdown = std::max(1, steps.touchdown / 2);
  steps.lift_off = std::max(1, steps.lift_off / 2);
  steps.onset = std::max(1, steps.onset / 2);
  steps.onset_growth *= steps.onset_growth; // the same distance with half as many steps
  return steps;
}

/// Solves the named coarser solutions on one mesh for each friction coefficient, and records them
/// at once. The skin's compliance that their solutions hold is released at the end, as the next
/// pass needs as much memory.
/// @param names coarser solutions that share this mesh
/// @param first,share part of the progress on coarser meshes that this pass takes, from `first` to
/// `first + share`
/// @param result receives the records, one entry per friction coefficient
void add_pass(const Case& input, const std::vector<std::string>& names,
              const std::vector<double>& frictions, const mechanics::ContactOptions& options,
              double first, double share, std::vector<CoarserSolutions>& result) {
  constexpr double solved = 0.9; // share of the pass that solving takes; recording takes the rest
  std::vector<mechanics::ContactVariant> variants;
  for (const double friction : frictions) {
    for (const std::string& name : names) {
      variants.push_back({friction, name == mechanics::coarser_solutions::path
                                        ? halved(options.steps)
                                        : options.steps});
    }
  }
  mechanics::ContactOptions own = options;
  own.unfinished = nullptr; // an unfinished coarser solution is no result
  own.progress = [&](std::string_view activity, double fraction) {
    activity == "mechanics" ? options.progress(coarser_activity, first + solved * share * fraction)
                            : options.progress(activity, fraction);
  };
  base::Timers parts; // not reported: the coarser solutions count as one stage
  auto solutions = mechanics::solve_variants(mechanics::coarser_case(input, names.front()),
                                             variants, own, parts);
  const auto recording =
      base::share_of(options.progress, first + solved * share, (1 - solved) * share);
  parallel::SharedProgress progress(std::string(coarser_activity), recording);
  progress.add_units(solutions.size());
  std::vector<std::shared_ptr<const MechanicsRecord>> records(solutions.size());
  parallel::run_tasks(solutions.size(), options.threads, [&](std::size_t i) {
    const auto contact = std::make_unique<mechanics::ContactSolution>(std::move(solutions[i]));
    MechanicsRecord record =
        make_mechanics_record(mechanics::coarser_case(input, names[i % names.size()]), *contact);
    record.maps = {};
    records[i] = std::make_shared<const MechanicsRecord>(std::move(record));
    progress.finish_unit();
  });
  base::return_free_memory();
  for (std::size_t i = 0; i < records.size(); ++i) {
    result[i / names.size()].emplace(names[i % names.size()], std::move(records[i]));
  }
}

/// Solves all coarser solutions; one entry per friction coefficient.
std::vector<CoarserSolutions> solve_coarser(const Case& input, const std::vector<double>& frictions,
                                            const mechanics::ContactOptions& options) {
  namespace names = mechanics::coarser_solutions;
  std::vector<CoarserSolutions> result(frictions.size());
  const double share = mechanics::needs_coarser_thickness(input) ? 0.5 : 1;
  add_pass(input, {names::mesh, names::path}, frictions, options, 0, share, result);
  if (share < 1) {
    add_pass(input, {names::thickness}, frictions, options, share, 1 - share, result);
  }
  return result;
}

/// Solves all coarser solutions; empty, with the reason in `problem`, if that fails. A run then
/// keeps its results without an error estimate.
std::vector<CoarserSolutions> try_coarser(const Case& input, const std::vector<double>& frictions,
                                          const mechanics::ContactOptions& options,
                                          std::string& problem) {
  try {
    return solve_coarser(input, frictions, options);
  } catch (const SolverError& error) {
    problem = error.what();
  } catch (const UserError& error) { // its mesh does not fit beside the slider
    problem = error.what();
  }
  return {};
}

/// Solves the coarser solutions and, beside them on other threads, the solutions of the run.
/// Progress of the run's solutions is reported only after the coarser ones are finished.
/// @param solutions receives the solutions of the run
/// @returns the coarser solutions
std::vector<CoarserSolutions> solve_beside(const Case& input, const std::vector<double>& frictions,
                                           const mechanics::ContactOptions& options,
                                           base::Timers& timers, std::string& problem,
                                           std::vector<mechanics::ContactSolution>& solutions) {
  mechanics::ContactOptions coarse = options, own = options;
  coarse.threads = std::max(1, options.threads / 2);
  own.threads = std::max(1, options.threads - coarse.threads);
  coarse.shared_threads = own.shared_threads = options.threads;
  coarse.spare = std::make_shared<parallel::SpareThreads>();
  std::mutex telling;
  bool coarser_solved = false;
  std::string own_activity = "mechanics";
  double own_fraction = 0;
  own.progress = [&](std::string_view activity, double fraction) {
    const std::lock_guard lock(telling);
    own_activity = activity;
    own_fraction = fraction;
    if (coarser_solved) {
      options.progress(activity, fraction);
    }
  };
  std::vector<CoarserSolutions> coarser_solutions;
  options.progress(coarser_activity, 0.0);
  const auto task = [&](std::size_t which) {
    if (which == 0) {
      const base::Timers::Scope scope(timers, "mechanics: companion");
      coarser_solutions = try_coarser(input, frictions, coarse, problem);
      const std::lock_guard lock(telling);
      coarser_solved = true;
      options.progress(own_activity, own_fraction);
      return;
    }
    solutions = mechanics::solve_contact(input, frictions, own, timers);
    for (int i = 1; i < own.threads; ++i) { // the calling thread is given when the task ends
      coarse.spare->give();
    }
  };
  parallel::run_tasks(2, std::min(2, options.threads), task, coarse.spare.get());
  return coarser_solutions;
}

std::string not_estimated(const std::string& problem) {
  return "The error of the mechanics is not estimated: on a mesh of twice the size " + problem +
         ".";
}

/// Names of the coarser solutions of a case, see mechanics/coarser_solutions.hpp.
std::vector<std::string> coarser_names(const Case& input) {
  namespace names = mechanics::coarser_solutions;
  std::vector<std::string> result{names::mesh, names::path};
  if (mechanics::needs_coarser_thickness(input)) {
    result.emplace_back(names::thickness);
  }
  return result;
}

/// Solves one coarser solution of several sliders and returns its record.
std::shared_ptr<const MechanicsRecord> solve_coarser_sliders(const Case& input,
                                                             const std::string& name,
                                                             mechanics::ContactOptions options) {
  const Case coarser = mechanics::coarser_case(input, name);
  if (name == mechanics::coarser_solutions::path) {
    options.steps = halved(options.steps);
  }
  options.threads = 1;
  base::Timers parts;
  MechanicsRecord record = make_mechanics_record(
      coarser, mechanics::solve_sliders(cases_of_sliders(coarser), options, parts));
  record.maps = {};
  for (SliderRecord& further : record.further_sliders) {
    further.maps = {};
  }
  return std::make_shared<const MechanicsRecord>(std::move(record));
}

/// Solves the coarser solutions of several sliders.
/// @param own task to run beside them, such as the run's own solution; empty for none
/// @param problem receives the reason where they have no solution
CoarserSolutions solve_coarser_sliders(const Case& input, const mechanics::ContactOptions& options,
                                       const std::function<void()>& own, std::string& problem) {
  const std::vector<std::string> names =
      input.numerics.error_estimate ? coarser_names(input) : std::vector<std::string>{};
  std::vector<std::shared_ptr<const MechanicsRecord>> records(names.size());
  mechanics::ContactOptions beside = options;
  beside.progress = base::no_progress;
  beside.unfinished = nullptr; // an unfinished coarser solution is no result
  std::mutex failing;
  const auto fail = [&](const char* why) {
    const std::lock_guard lock(failing);
    problem = why;
  };
  const std::size_t before = own ? 1 : 0;
  parallel::run_tasks(before + names.size(), options.threads, [&](std::size_t task) {
    if (task < before) {
      own();
      return;
    }
    const std::size_t i = task - before;
    try { // a run keeps its results where their error cannot be estimated
      records[i] = solve_coarser_sliders(input, names[i], beside);
    } catch (const SolverError& error) {
      fail(error.what());
    } catch (const UserError& error) { // its mesh does not fit beside a slider
      fail(error.what());
    }
  });
  CoarserSolutions result;
  for (std::size_t i = 0; problem.empty() && i < records.size(); ++i) {
    result.emplace(names[i], std::move(records[i]));
  }
  return result;
}

/// Solves several sliders on one skin, and their coarser solutions beside them.
SolvedMechanics solve_together(const Case& input, const mechanics::ContactOptions& options,
                               base::Timers& timers) {
  SolvedMechanics solved;
  std::string problem;
  const auto own = [&] {
    solved.contacts = mechanics::solve_sliders(cases_of_sliders(input), options, timers);
  };
  solved.coarser_solutions = solve_coarser_sliders(input, options, own, problem);
  if (!problem.empty()) {
    solved.contacts.front().warnings.push_back(not_estimated(problem));
  }
  return solved;
}

} // namespace

std::vector<SolvedMechanics> solve_mechanics(const Case& input,
                                             const std::vector<double>& frictions,
                                             const mechanics::ContactOptions& options,
                                             base::Timers& timers) {
  if (!input.further_sliders.empty()) {
    std::vector<SolvedMechanics> solved;
    for (const double friction : frictions) {
      Case own = input;
      own.contact.friction = friction;
      solved.push_back(solve_together(own, options, timers));
    }
    return solved;
  }
  mechanics::ContactOptions both = options;
  if (!both.footprint) {
    const base::Timers::Scope scope(timers, "mechanics: footprint");
    both.footprint =
        mechanics::find_footprint(input, frictions.front(), options.threads, options.progress)
            .footprint;
    if (!input.slider.sharp()) { // its mesh was only a guess before
      planning::require_resources(input, options.threads, both.footprint);
    }
  }
  std::string problem;
  std::vector<CoarserSolutions> solved_coarser;
  std::vector<mechanics::ContactSolution> solutions;
  if (input.numerics.error_estimate) {
    solved_coarser = solve_beside(input, frictions, both, timers, problem, solutions);
  } else {
    solved_coarser.resize(frictions.size());
    options.progress("mechanics", 0.0);
    solutions = mechanics::solve_contact(input, frictions, both, timers);
  }
  std::vector<SolvedMechanics> solved;
  for (std::size_t i = 0; i < frictions.size(); ++i) {
    solved.emplace_back().contacts.push_back(std::move(solutions[i]));
    if (solved_coarser.empty()) {
      solved.back().contacts.front().warnings.push_back(not_estimated(problem));
    } else {
      solved.back().coarser_solutions = std::move(solved_coarser[i]);
    }
  }
  return solved;
}

void add_coarser_solutions(const Case& input, const mechanics::ContactOptions& options,
                           MechanicsRecord& record) {
  std::string problem;
  if (!input.further_sliders.empty()) {
    record.coarser_solutions = solve_coarser_sliders(input, options, nullptr, problem);
    return;
  }
  mechanics::ContactOptions own = options;
  if (!own.footprint) {
    own.footprint =
        mechanics::find_footprint(input, input.contact.friction, options.threads).footprint;
  }
  for (CoarserSolutions& solved : try_coarser(input, {input.contact.friction}, own, problem)) {
    record.coarser_solutions = std::move(solved);
  }
}

MechanicsRecord record_mechanics(const Case& input, const SolvedMechanics& solved,
                                 const base::ProgressCallback& progress) {
  MechanicsRecord record = make_mechanics_record(input, solved.contacts, progress);
  record.coarser_solutions = solved.coarser_solutions;
  return record;
}

} // namespace ionskin::study
