// SPDX-License-Identifier: Apache-2.0
#include "study_verbs/sweep.hpp"

#include "command_line/study_settings.hpp"
#include "ionskin/base/error.hpp"
#include "ionskin/base/system/interrupt.hpp"
#include "ionskin/study/sweep/sweep.hpp"
#include "study_verbs/python_verbs.hpp"
#include "study_verbs/sweep_cost.hpp"
#include "terminal/terminal.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdio>
#include <optional>
#include <unistd.h>
#include <utility>

namespace ionskin::apps {
namespace {

study::SweepRequest request(const SweepOptions& options) {
  study::SweepRequest result;
  result.case_path = options.case_path;
  result.set_edits = options.set_edits;
  result.over = options.over;
  result.samples = options.samples;
  result.sampling =
      options.sampling == "latin" ? study::Sampling::latin_hypercube : study::Sampling::sobol;
  result.seed = options.seed;
  return result;
}

void print_outcome(const SweepOptions& options, const study::SweepOutcome& outcome) {
  fmt::print("{} of {} points finished, {:.1f} s in all\n",
             outcome.points - outcome.failures.size() - outcome.missing.size(), outcome.points,
             outcome.seconds);
  if (options.batch) {
    return;
  }
  fmt::print("table: {}/sweep.csv\n", options.output);
  if (outcome.report.empty()) {
    fmt::print("report: ionskin report {}\n", options.output);
  } else {
    fmt::print("report: {}\n", outcome.report.string());
  }
}

/// Prints the batches of a planned sweep and the commands that run them.
void print_plan(const SweepOptions& options, const study::PlannedFolder& folder) {
  double longest = 0, largest = 0;
  for (const study::SweepBatch& batch : folder.batches) {
    longest = std::max(longest, batch.seconds);
    largest = std::max(largest, batch.memory);
  }
  fmt::print(
      "plan: {}/plan.json\n{} batches, 0 to {}, {} of them with points to solve; the longest "
      "takes about {:.2g} s, the largest about {:.2g} GB\n"
      "do each: ionskin sweep --do-batch K -o {}\n"
      "then: ionskin sweep --collect -o {}\n",
      options.output, folder.batches.size(), folder.batches.size() - 1, folder.unfinished.size(),
      longest, 1e-9 * largest, options.output, options.output);
}

void print_problems(const SweepOptions& options, const study::SweepOutcome& outcome) {
  if (!outcome.failures.empty()) {
    fmt::print(stderr, "warning: {} of {} points failed; {}. The first, {}: {}\n",
               outcome.failures.size(), outcome.points,
               options.batch ? "--do-batch tries them again"
                             : "sweep.csv has every reason, --resume tries them again",
               outcome.failures.begin()->first, outcome.failures.begin()->second);
  }
  if (!outcome.missing.empty()) {
    fmt::print(
        stderr,
        "warning: {} of {} points are still to be solved, the first is {}: do their batches, "
        "or finish the sweep with --resume\n",
        outcome.missing.size(), outcome.points, outcome.missing.front());
  }
  if (!outcome.report_problem.empty()) {
    fmt::print(stderr, "error: {}\n", outcome.report_problem);
  }
}

ExitCode exit_code(const study::SweepOutcome& outcome) {
  if (!outcome.missing.empty() || !outcome.report_problem.empty()) {
    return ExitCode::unfinished;
  }
  return outcome.failures.size() < outcome.points ? ExitCode::success : ExitCode::solver_gave_up;
}

/// True if this process solves the points.
bool here(const SweepOptions& options) {
  return !options.plan && options.on.empty();
}

study::SweepOptions settings_of(const SweepOptions& options, const std::string& command,
                                ProgressDisplay& display) {
  auto settings = study_settings<study::SweepOptions>(options, command, display);
  settings.resume = options.resume;
  settings.report = !options.no_report;
  settings.figures = options.figures;
  settings.studies = options.only == "mechanics" ? study::Studies::mechanics : study::Studies::both;
  if (!here(options)) { // other machines have other processors
    settings.threads = std::max(1, options.threads);
  } else if (options.batch) {
    settings.threads = options.threads;
  }
  return settings;
}

/// Estimated time of the report [s]: processor time of a report of ten points, and of its figures
/// as files, divided over the processes that draw them.
double report_seconds(const SweepOptions& options, int threads) {
  constexpr double page = 8.0, files = 9.0;
  return options.no_report ? 0.0 : (page + (options.figures ? files : 0.0)) / threads;
}

/// Plans a sweep and prints its cost, with --explain on stdout; nullopt after --explain, when
/// nothing else is to do.
std::optional<study::SweepPlan> planned(const SweepOptions& options) {
  study::SweepPlan plan = study::plan_sweep(request(options));
  if (options.explain || options.log == LogFormat::automatic) {
    const int threads =
        here(options) ? thread_count(options.threads) : std::max(1, options.threads);
    const std::string cost =
        sweep_cost(plan, options.only != "mechanics", threads, report_seconds(options, threads));
    std::FILE* file = options.explain ? stdout : stderr;
    fmt::print(file, "{}", paragraph(cost, 2, fileno(file)));
  }
  return options.explain ? std::nullopt : std::optional(std::move(plan));
}

int plan_only(const SweepOptions& options, const std::string& command) {
  const auto plan = planned(options);
  if (plan) {
    ProgressDisplay display(LogFormat::none);
    const auto folder = study::plan_sweep_folder(*plan, settings_of(options, command, display));
    if (options.log != LogFormat::quiet) {
      print_plan(options, folder);
    }
  }
  return static_cast<int>(ExitCode::success);
}

std::string batch_progress(LogFormat log) {
  switch (log) {
  case LogFormat::automatic:
    return isatty(STDERR_FILENO) != 0 ? "bar" : "lines";
  case LogFormat::bar:
    return "bar";
  case LogFormat::lines:
    return "lines";
  case LogFormat::json:
    return "json";
  case LogFormat::none:
  case LogFormat::quiet:
    return "none";
  }
  return "";
}

/// Runs a sweep on a cluster: this process plans it, the workers run its batches, this process
/// collects the results. Returns the exit code.
int sweep_on_cluster(const SweepOptions& options, const std::string& command) {
  const auto plan = planned(options);
  if (!plan) {
    return static_cast<int>(ExitCode::success);
  }
  ProgressDisplay display(LogFormat::none);
  const auto settings = settings_of(options, command, display);
  const auto folder = study::plan_sweep_folder(*plan, settings);
  const int code = folder.unfinished.empty() ? 0
                                             : do_batches_on_cluster(options, folder.unfinished,
                                                                     batch_progress(options.log));
  base::check_interrupt();
  if (code == static_cast<int>(ExitCode::user_error)) {
    return code; // before any work
  }
  const study::SweepOutcome outcome = study::collect_sweep(settings);
  print_problems(options, outcome);
  if (options.log != LogFormat::quiet) {
    print_outcome(options, outcome);
  }
  return code != 0 ? code : static_cast<int>(exit_code(outcome));
}

} // namespace

int sweep(const SweepOptions& options, const std::string& command) {
  base::install_interrupt_handler();
  if (options.plan) {
    return plan_only(options, command);
  }
  if (!options.on.empty()) {
    return sweep_on_cluster(options, command);
  }
  std::optional<study::SweepPlan> plan;
  if (!options.batch && !options.collect && !(plan = planned(options))) {
    return static_cast<int>(ExitCode::success);
  }
  study::SweepOutcome outcome;
  {
    ProgressDisplay display(options.log);
    const auto settings = settings_of(options, command, display);
    outcome = options.collect ? study::collect_sweep(settings)
              : options.batch ? study::do_batch(*options.batch, settings)
                              : study::run_sweep(*plan, settings);
  }
  print_problems(options, outcome);
  if (options.log != LogFormat::quiet) {
    print_outcome(options, outcome);
  }
  return static_cast<int>(exit_code(outcome));
}

} // namespace ionskin::apps
