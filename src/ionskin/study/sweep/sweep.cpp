// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/sweep/sweep.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/base/files/atomic_file.hpp"
#include "ionskin/electrochemistry/time/problem_size.hpp"
#include "ionskin/parallel/task_pool.hpp"
#include "ionskin/planning/resources.hpp"
#include "ionskin/results/output_folder.hpp"
#include "ionskin/results/summary_json.hpp"
#include "ionskin/study/run/report.hpp"
#include "ionskin/study/run/run_folder.hpp"
#include "ionskin/study/sweep/point_failure.hpp"
#include "ionskin/study/sweep/sweep_mechanics.hpp"
#include "ionskin/study/sweep/sweep_table.hpp"

#include <algorithm>
#include <mutex>
#include <numeric>

namespace ionskin::study {
namespace {

namespace fs = std::filesystem;

constexpr double memory_bound = 2.4e9; // bytes for the ion transport of all points at once

RunOptions sweep_folder_options(const SweepOptions& options) {
  RunOptions result;
  result.folder = options.folder;
  result.threads = options.threads;
  result.overwrite = options.overwrite;
  result.resume = options.resume;
  result.use_cache = options.use_cache;
  result.command = options.command;
  return result;
}

RunOptions point_options(const SweepOptions& options) {
  RunOptions result = sweep_folder_options(options);
  result.folder = options.folder / results::file_names::points;
  result.overwrite = false;
  result.resume = true;
  result.studies = options.studies;
  result.report = false;
  result.paraview = false;
  result.progress = options.progress;
  return result;
}

/// What the points' folders tell, the progress over all of them, and the table on disk.
class SweepRecord {
public:
  SweepRecord(const SweepPlan& plan, const SweepOptions& options, const fs::path& table)
      : plan_(plan), options_(options), table_(table), states_(plan.points.size()),
        fractions_(plan.points.size(), 0.0) {
    for (std::size_t i = 0; i < states_.size(); ++i) {
      take_up(i);
    }
  }

  std::vector<std::size_t> unfinished() const {
    std::vector<std::size_t> result;
    for (std::size_t i = 0; i < states_.size(); ++i) {
      if (states_[i].status == PointStatus::pending) {
        result.push_back(i);
      }
    }
    return result;
  }

  void finish(std::size_t i, std::vector<readout::Metric> metrics) {
    settle(i, {PointStatus::finished, "", std::move(metrics)});
  }
  void fail(std::size_t i, const std::string& reason) {
    settle(i, {PointStatus::failed, reason, {}});
  }
  void progress(std::size_t i, double fraction) {
    const std::lock_guard lock(mutex_);
    fractions_[i] = std::max(fractions_[i], fraction);
    show();
  }
  void write_table() const {
    base::write_text_file(table_, sweep_table_text(plan_.points, states_));
  }
  const std::vector<PointState>& states() const { return states_; }

private:
  void take_up(std::size_t i) {
    const fs::path folder = options_.folder / results::file_names::points / plan_.points[i].name;
    if (holds_finished_run(folder, plan_.points[i].input, options_.studies)) {
      states_[i] = {PointStatus::finished, "",
                    results::read_metrics(folder / results::file_names::summary)};
      fractions_[i] = 1;
    }
  }
  void settle(std::size_t i, PointState state) {
    const std::lock_guard lock(mutex_);
    states_[i] = std::move(state);
    fractions_[i] = 1;
    write_table();
    show();
  }
  void show() const {
    options_.progress("ion transport of all points",
                      std::accumulate(fractions_.begin(), fractions_.end(), 0.0) /
                          static_cast<double>(fractions_.size()));
  }

  const SweepPlan& plan_;
  const SweepOptions& options_;
  fs::path table_;
  std::vector<PointState> states_;
  std::vector<double> fractions_;
  std::mutex mutex_;
};

/// One point from its mechanics on; whatever goes wrong with it stays with it.
void run_point(const SweepPlan& plan, std::size_t i, RunOptions options, SweepRecord& record) {
  options.folder /= plan.points[i].name;
  options.progress = [&record, i](std::string_view activity, double fraction) {
    if (activity == "ion transport") {
      record.progress(i, 0.95 * fraction);
    }
  };
  if (const auto reason =
          failure_of([&] { record.finish(i, run_case(plan.points[i].input, options).metrics); })) {
    record.fail(i, *reason);
  }
}

void run_points(const SweepPlan& plan, const SweepOptions& options, SweepRecord& record) {
  const std::vector<std::size_t> points = record.unfinished();
  if (points.empty()) {
    return;
  }
  double largest = 0;
  for (const std::size_t i : points) {
    const Case& input = plan.points[i].input;
    if (input.strain.kind == StrainSourceKind::contact) {
      largest = std::max(largest, electrochemistry::estimate_problem_size(input).memory);
    }
  }
  const auto fitting = static_cast<int>(std::min(1e6, memory_bound / std::max(1.0, largest)));
  const int at_once =
      std::clamp(std::min(options.threads, fitting), 1, static_cast<int>(points.size()));
  RunOptions settings = point_options(options);
  settings.threads = std::max(1, options.threads / at_once);
  parallel::run_tasks(points.size(), at_once,
                      [&](std::size_t i) { run_point(plan, points[i], settings, record); });
}

void note_cost(RunFolder& folder, const base::Timers& timers) {
  for (const auto& [stage, seconds] : timers.seconds()) {
    folder.set_counter("seconds_" + stage, seconds);
  }
}

/// Runs a stage of the sweep and notes its processor time.
template <class Work> void timed_stage(RunFolder& folder, const std::string& name, Work&& work) {
  const double before = base::processor_time();
  folder.stage(name, [&] {
    work();
    folder.set_counter("processor_seconds_" + name, base::processor_time() - before);
    return true;
  });
}

} // namespace

SweepOutcome run_sweep(const SweepPlan& plan, const SweepOptions& options) {
  const double start = base::wall_time();
  for (const SweepPoint& point : plan.points) {
    planning::require_resources(point.input, options.threads);
  }
  RunFolder folder(plan.base, sweep_folder_options(options));
  SweepRecord record(plan, options, folder.own(results::file_names::sweep_table));
  record.write_table();
  base::Timers timers;
  timed_stage(folder, "mechanics", [&] {
    for (const auto& [i, reason] :
         solve_shared_mechanics(plan.points, record.unfinished(), point_options(options), timers)) {
      record.fail(i, reason);
    }
  });
  timed_stage(folder, "points", [&] { run_points(plan, options, record); });
  timed_stage(folder, "output", [&] {
    record.write_table();
    write_sweep_signals(options.folder, folder.own(results::file_names::sweep_signals), plan.points,
                        record.states());
  });
  note_cost(folder, timers);

  SweepOutcome outcome;
  outcome.points = plan.points.size();
  for (std::size_t i = 0; i < plan.points.size(); ++i) {
    if (record.states()[i].status == PointStatus::failed) {
      outcome.failures[plan.points[i].name] = record.states()[i].reason;
    }
  }
  folder.finish();
  if (options.report && outcome.failures.size() < outcome.points) {
    options.progress("report", 0.0);
    outcome.report_problem = make_report(options.folder).value_or("");
    options.progress("report", 1.0);
    if (outcome.report_problem.empty()) {
      outcome.report = folder.file(results::file_names::report);
    }
  }
  outcome.seconds = base::wall_time() - start;
  return outcome;
}

} // namespace ionskin::study
