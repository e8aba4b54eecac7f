// SPDX-License-Identifier: Apache-2.0
#include "study_verbs/sweep.hpp"

#include "command_line/study_settings.hpp"
#include "ionskin/base/error.hpp"
#include "ionskin/base/system/interrupt.hpp"
#include "ionskin/study/sweep/sweep.hpp"
#include "study_verbs/sweep_cost.hpp"

#include <fmt/core.h>

#include <cstdio>

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
  fmt::print("{} of {} points finished, {:.1f} s in all\ntable: {}/sweep.csv\n",
             outcome.points - outcome.failures.size(), outcome.points, outcome.seconds,
             options.output);
  if (outcome.report.empty()) {
    fmt::print("figures and report: ionskin report {}\n", options.output);
  } else {
    fmt::print("report: {}\n", outcome.report.string());
  }
}

void print_problems(const study::SweepOutcome& outcome) {
  if (!outcome.failures.empty()) {
    fmt::print(stderr,
               "warning: {} of {} points failed; sweep.csv has every reason, --resume tries them "
               "again. The first, {}: {}\n",
               outcome.failures.size(), outcome.points, outcome.failures.begin()->first,
               outcome.failures.begin()->second);
  }
  if (!outcome.report_problem.empty()) {
    fmt::print(stderr, "warning: {}\n", outcome.report_problem);
  }
}

} // namespace

int sweep(const SweepOptions& options, const std::string& command) {
  base::install_interrupt_handler();
  const study::SweepPlan plan = study::plan_sweep(request(options));
  const bool both_studies = options.only != "mechanics";
  if (options.explain || options.log == LogFormat::automatic) {
    const std::string cost = sweep_cost(plan, both_studies, thread_count(options.threads));
    fmt::print(options.explain ? stdout : stderr, "{}\n", cost);
  }
  if (options.explain) {
    return static_cast<int>(ExitCode::success);
  }
  study::SweepOutcome outcome;
  if (options.log != LogFormat::quiet) {
    announce_cache(options.use_cache);
  }
  {
    ProgressDisplay display(options.log);
    auto settings = study_settings<study::SweepOptions>(options, command, display);
    settings.resume = options.resume;
    settings.report = !options.no_report;
    settings.studies = both_studies ? study::Studies::both : study::Studies::mechanics;
    outcome = study::run_sweep(plan, settings);
  }
  print_problems(outcome);
  if (options.log != LogFormat::quiet) {
    print_outcome(options, outcome);
  }
  return static_cast<int>(outcome.failures.size() < outcome.points ? ExitCode::success
                                                                   : ExitCode::solver_gave_up);
}

} // namespace ionskin::apps
