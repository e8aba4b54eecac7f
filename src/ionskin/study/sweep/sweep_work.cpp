// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/sweep/sweep_work.hpp"

#include "ionskin/electrochemistry/time/problem_size.hpp"
#include "ionskin/parallel/task_pool.hpp"
#include "ionskin/study/run/run_folder.hpp"
#include "ionskin/study/sweep/point_failure.hpp"
#include "ionskin/study/sweep/sweep_mechanics.hpp"

#include <algorithm>
#include <utility>

namespace ionskin::study {
namespace {

constexpr double memory_bound = 2.4e9; // memory for the ion transport of all points at once [bytes]

/// Replaces the path of the staging folder in a reason of failure, so that it is the same wherever
/// the point was solved.
std::string without_staging(std::string text, const std::string& staged, const std::string& name) {
  for (std::size_t at = 0; (at = text.find(staged, at)) != std::string::npos;) {
    text.replace(at, staged.size(), name);
    at += name.size();
  }
  return text;
}

} // namespace

SweepWork::SweepWork(const SweepPlan& plan, const std::vector<std::size_t>& chosen,
                     RunOptions options, const StagingPlace& place, SweepRecord& record)
    : plan_(plan), options_(std::move(options)), place_(place), record_(record),
      unfinished_(record.begin(chosen)) {
  options_.folder = place.path();
  options_.overwrite = false;
  options_.resume = true;
  options_.report = false;
  options_.paraview = false;
}

void SweepWork::solve_mechanics(base::Timers& timers,
                                const std::filesystem::path& finished_points) {
  for (const auto& [i, reason] :
       solve_shared_mechanics(plan_.points, unfinished_, options_, finished_points, timers)) {
    fail(i, reason);
  }
  std::erase_if(unfinished_,
                [&](std::size_t i) { return record_.states()[i].status != PointStatus::pending; });
}

void SweepWork::run_points() {
  if (unfinished_.empty()) {
    return;
  }
  double largest = 0;
  for (const std::size_t i : unfinished_) {
    const Case& input = plan_.points[i].input;
    if (input.strain.kind != StrainSourceKind::file) { // whose history is not read yet
      largest = std::max(largest, electrochemistry::estimate_problem_size(input).memory);
    }
  }
  const auto fitting = static_cast<int>(std::min(1e6, memory_bound / std::max(1.0, largest)));
  const int at_once =
      std::clamp(std::min(options_.threads, fitting), 1, static_cast<int>(unfinished_.size()));
  RunOptions settings = options_;
  settings.threads = std::max(1, options_.threads / at_once);
  parallel::run_tasks(unfinished_.size(), at_once,
                      [&](std::size_t i) { run_point(unfinished_[i], settings); });
}

/// Runs one point from its mechanics on; a failure stays with the point.
void SweepWork::run_point(std::size_t point, RunOptions options) {
  options.folder /= plan_.points[point].name;
  // Memory and disk were checked for the whole sweep, and other programs may have taken some since.
  options.judge_resources = false;
  options.progress = [this, point](std::string_view activity, double fraction) {
    if (activity == "ion transport") {
      record_.progress(point, 0.95 * fraction);
    }
  };
  std::vector<readout::Metric> metrics;
  if (const auto reason =
          failure_of([&] { metrics = run_case(plan_.points[point].input, options).metrics; })) {
    fail(point, *reason);
    return;
  }
  place_.publish(plan_.points[point], options_.studies);
  record_.settle(point, {PointStatus::finished, "", std::move(metrics)});
}

void SweepWork::fail(std::size_t point, const std::string& reason) {
  const SweepPoint& failed = plan_.points[point];
  RunOptions options = options_;
  options.folder /= failed.name;
  const std::string message =
      without_staging(reason, options.folder.string(),
                      std::string(results::file_names::points) + "/" + failed.name);
  RunFolder(failed.input, options).fail(message);
  place_.publish(failed, options_.studies);
  record_.settle(point, {PointStatus::failed, message, {}});
}

} // namespace ionskin::study
