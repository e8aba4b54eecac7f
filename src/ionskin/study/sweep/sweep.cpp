// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/sweep/sweep.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/base/files/atomic_file.hpp"
#include "ionskin/planning/output_size.hpp"
#include "ionskin/planning/resources.hpp"
#include "ionskin/results/output_folder.hpp"
#include "ionskin/study/run/report.hpp"
#include "ionskin/study/run/run_folder.hpp"
#include "ionskin/study/sweep/sweep_folder.hpp"
#include "ionskin/study/sweep/sweep_table.hpp"
#include "ionskin/study/sweep/sweep_work.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace ionskin::study {
namespace {

namespace fs = std::filesystem;
namespace names = results::file_names;

RunOptions run_options(const SweepOptions& options) {
  RunOptions result;
  result.folder = options.folder;
  result.threads = options.threads;
  result.overwrite = options.overwrite;
  result.resume = options.resume;
  result.studies = options.studies;
  result.command = options.command;
  result.progress = options.progress;
  return result;
}

/// Options for the folder of the whole sweep. Its studies are `both`, as those of the points do not
/// concern it.
RunOptions folder_options(const SweepOptions& options) {
  RunOptions result = run_options(options);
  result.studies = Studies::both;
  return result;
}

std::vector<PointState> read_states(const fs::path& folder, const SweepPlan& plan,
                                    Studies studies) {
  std::vector<PointState> states;
  for (const SweepPoint& point : plan.points) {
    states.push_back(read_point_state(folder / names::points, point, studies));
  }
  return states;
}

void note_cost(RunFolder& folder, const base::Timers& timers) {
  for (const auto& [stage, seconds] : timers.seconds()) {
    folder.set_counter("seconds_" + stage, seconds);
  }
}

/// Runs a stage of the sweep and records its processor time.
template <class Work> void timed_stage(RunFolder& folder, const std::string& name, Work&& work) {
  const double before = base::processor_time();
  folder.stage(name, [&] {
    work();
    folder.set_counter("processor_seconds_" + name, base::processor_time() - before);
    return true;
  });
}

std::vector<SweepBatch> write_plan(const SweepPlan& plan, const SweepOptions& options,
                                   RunFolder& folder) {
  auto batches = plan_batches(plan.points, options.studies, options.threads);
  base::write_text_file(folder.own(names::sweep_plan), plan_text(plan, batches, options.studies));
  return batches;
}

SweepOutcome outcome_of(const SweepPlan& plan, const std::vector<std::size_t>& points,
                        const std::vector<PointState>& states) {
  SweepOutcome outcome;
  outcome.points = points.size();
  for (const std::size_t i : points) {
    if (states[i].status == PointStatus::failed) {
      outcome.failures[plan.points[i].name] = states[i].reason;
    } else if (states[i].status == PointStatus::pending) {
      outcome.missing.push_back(plan.points[i].name);
    }
  }
  return outcome;
}

std::vector<std::size_t> all_points(const SweepPlan& plan) {
  std::vector<std::size_t> result(plan.points.size());
  std::iota(result.begin(), result.end(), 0);
  return result;
}

/// Writes the tables from the points that are finished, and the report.
SweepOutcome collect(const SweepPlan& plan, const std::vector<PointState>& states,
                     const SweepOptions& options, RunFolder& folder) {
  timed_stage(folder, "output", [&] {
    base::write_text_file(folder.own(names::sweep_table), sweep_table_text(plan.points, states));
    write_sweep_signals(options.folder, folder.own(names::sweep_signals), plan.points, states);
  });
  SweepOutcome outcome = outcome_of(plan, all_points(plan), states);
  if (outcome.missing.empty()) {
    folder.finish();
  } else {
    folder.set_state("interrupted");
  }
  if (options.report && outcome.failures.size() + outcome.missing.size() < outcome.points) {
    options.progress("report", 0.0);
    outcome.report_problem = make_report(options.folder, options.figures, [&](double part) {
                               options.progress("report", part);
                             }).value_or("");
    options.progress("report", 1.0);
    if (outcome.report_problem.empty()) {
      outcome.report = folder.file(names::report);
    }
  }
  return outcome;
}

/// Checks, before any work, that the files of points without a run folder have room on the disk.
/// Points with a strain file are left to their own runs, as only the file tells how long they last.
void require_room(const SweepPlan& plan, const std::vector<std::size_t>& points,
                  const fs::path& folder, Studies studies) {
  double bytes = 0;
  for (const std::size_t i : points) {
    const SweepPoint& point = plan.points[i];
    if (point.input.strain.kind != StrainSourceKind::file &&
        !fs::exists(folder / names::points / point.name)) {
      bytes += planning::expected_output(point.input, studies != Studies::mechanics);
    }
  }
  planning::require_disk(bytes, folder);
}

} // namespace

SweepOutcome run_sweep(const SweepPlan& plan, const SweepOptions& options) {
  const double start = base::wall_time();
  for (const SweepPoint& point : plan.points) {
    planning::require_resources(point.input, options.threads);
  }
  require_room(plan, all_points(plan), options.folder, options.studies);
  RunFolder folder(plan.base, folder_options(options));
  write_plan(plan, options, folder);
  settle_staging(options.folder, plan, options.studies, false);
  SweepRecord record(plan.points, read_states(options.folder, plan, options.studies),
                     options.progress, folder.own(names::sweep_table));
  {
    base::Timers timers;
    const StagingPlace place(options.folder, "sweep");
    SweepWork work(plan, all_points(plan), run_options(options), place, record);
    timed_stage(folder, "mechanics",
                [&] { work.solve_mechanics(timers, options.folder / names::points); });
    timed_stage(folder, "points", [&] { work.run_points(); });
    note_cost(folder, timers);
  }
  settle_staging(options.folder, plan, options.studies, true);
  SweepOutcome outcome = collect(plan, record.states(), options, folder);
  outcome.seconds = base::wall_time() - start;
  return outcome;
}

PlannedFolder plan_sweep_folder(const SweepPlan& plan, const SweepOptions& options) {
  for (const SweepPoint& point : plan.points) {
    planning::shortage(point.input, options.threads); // throws for what no machine can do
  }
  require_room(plan, all_points(plan), options.folder, options.studies);
  RunFolder folder(plan.base, folder_options(options));
  PlannedFolder result{write_plan(plan, options, folder), {}};
  settle_staging(options.folder, plan, options.studies, false);
  const auto states = read_states(options.folder, plan, options.studies);
  for (std::size_t i = 0; i < result.batches.size(); ++i) {
    const auto& points = result.batches[i].points;
    if (std::any_of(points.begin(), points.end(), [&](std::size_t point) {
          return states[point].status != PointStatus::finished;
        })) {
      result.unfinished.push_back(i);
    }
  }
  folder.set_state("planned");
  return result;
}

SweepOutcome do_batch(std::size_t batch, const SweepOptions& options) {
  const double start = base::wall_time();
  const auto lock = results::lock_output_folder(options.folder, results::LockKind::shared);
  const PlannedSweep sweep = read_planned_sweep(options.folder, batch);
  const SweepBatch& chosen = sweep.batches[batch];
  RunOptions settings = run_options(options);
  settings.threads = options.threads > 0 ? options.threads : chosen.threads;
  settings.studies = sweep.studies;
  for (const std::size_t i : chosen.points) {
    planning::require_resources(sweep.plan.points[i].input, settings.threads);
  }
  require_room(sweep.plan, chosen.points, options.folder, sweep.studies);
  std::vector<PointState> states(sweep.plan.points.size());
  for (const std::size_t i : chosen.points) {
    states[i] =
        read_point_state(options.folder / names::points, sweep.plan.points[i], sweep.studies);
  }
  SweepRecord record(sweep.plan.points, std::move(states), options.progress, {});
  const StagingPlace place(options.folder, fmt::format("batch-{:04}", batch));
  SweepWork work(sweep.plan, chosen.points, settings, place, record);
  base::Timers timers;
  work.solve_mechanics(timers, options.folder / names::points);
  work.run_points();
  SweepOutcome outcome = outcome_of(sweep.plan, chosen.points, record.states());
  outcome.seconds = base::wall_time() - start;
  return outcome;
}

SweepOutcome collect_sweep(const SweepOptions& options) {
  const double start = base::wall_time();
  const PlannedSweep sweep = read_planned_sweep(options.folder, std::nullopt);
  const auto alone =
      results::lock_path(options.folder / names::sweep_plan, results::LockKind::exclusive);
  if (!alone) {
    throw UserError(fmt::format("another ionskin collects the tables of {}\n  = wait until it has "
                                "ended",
                                options.folder.string()));
  }
  RunOptions settings = folder_options(options);
  settings.overwrite = false; // earlier results were replaced when the sweep was planned
  settings.resume = true;
  settings.beside_others = true;
  RunFolder folder(sweep.plan.base, settings);
  settle_staging(options.folder, sweep.plan, sweep.studies, false);
  const auto states = read_states(options.folder, sweep.plan, sweep.studies);
  if (std::all_of(states.begin(), states.end(),
                  [](const PointState& state) { return state.status != PointStatus::pending; })) {
    settle_staging(options.folder, sweep.plan, sweep.studies, true);
  }
  SweepOutcome outcome = collect(sweep.plan, states, options, folder);
  outcome.seconds = base::wall_time() - start;
  return outcome;
}

} // namespace ionskin::study
