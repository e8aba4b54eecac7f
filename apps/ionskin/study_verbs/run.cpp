// SPDX-License-Identifier: Apache-2.0
#include "study_verbs/run.hpp"

#include "command_line/study_settings.hpp"
#include "ionskin/base/error.hpp"
#include "ionskin/base/system/interrupt.hpp"
#include "ionskin/case/reading/read_case.hpp"
#include "ionskin/planning/cost_estimate.hpp"
#include "ionskin/planning/output_size.hpp"
#include "ionskin/results/output_folder.hpp"
#include "ionskin/study/run/python_module.hpp"
#include "ionskin/study/run/run_case.hpp"
#include "terminal/terminal.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdio>
#include <string>

namespace ionskin::apps {
namespace {

study::Studies studies(const std::string& only) {
  if (only == "mechanics") {
    return study::Studies::mechanics;
  }
  return only == "electrochemistry" ? study::Studies::electrochemistry : study::Studies::both;
}

/// Prints notes when a run will write gigabytes or take minutes; not for a strain file, whose size
/// follows from the file.
void announce(const Case& input, int threads) {
  if (input.strain.kind != StrainSourceKind::file) {
    const planning::CostEstimate cost = planning::estimate_cost(input, threads);
    for (const std::string& note :
         {planning::announced_output(input, cost.output), planning::announced_time(input, cost)}) {
      if (!note.empty()) {
        fmt::print(stderr, "{}", paragraph("note: " + note, 2, fileno(stderr)));
      }
    }
  }
}

/// Prints the first warnings of a run and the number of the rest, since a long motion may have one
/// for every instant.
void print_warnings(const study::RunOutcome& outcome) {
  constexpr std::size_t most = 6;
  const std::size_t shown = std::min(most, outcome.warnings.size());
  for (std::size_t i = 0; i < shown; ++i) {
    fmt::print("{}", paragraph("warning: " + outcome.warnings[i], 2));
  }
  if (shown < outcome.warnings.size()) {
    fmt::print("{} more warning{}: {}\n", outcome.warnings.size() - shown,
               outcome.warnings.size() - shown == 1 ? "" : "s",
               (outcome.folder / results::file_names::summary).string());
  }
}

void print_outcome(const study::RunOutcome& outcome) {
  std::fflush(stdout); // the names and units of numbers are those of the page
  if (study::run_python_module("ionskin.page.terminal", {outcome.folder.string()},
                               study::PythonErrors::captured)
          .exit_code != 0) {
    fmt::print("numbers: {}\n", (outcome.folder / results::file_names::summary).string());
  }
  print_warnings(outcome);
  fmt::print("{:.1f} s in all\n", outcome.seconds);
  if (outcome.report.empty()) {
    fmt::print("results: {}\n", outcome.folder.string());
  } else {
    fmt::print("report: {}\n", outcome.report.string());
  }
}

} // namespace

int run(const RunOptions& options, const std::string& command) {
  base::install_interrupt_handler();
  const Case input = read_case(options.case_path, options.set_edits);
  study::RunOutcome outcome;
  if (options.log != LogFormat::quiet) {
    announce(input, thread_count(options.threads));
  }
  {
    ProgressDisplay display(options.log);
    auto settings = study_settings<study::RunOptions>(options, command, display);
    settings.resume = options.resume;
    settings.studies = studies(options.only);
    settings.report = !options.no_report;
    settings.figures = options.figures;
    outcome = study::run_case(input, settings);
  }
  if (options.log != LogFormat::quiet) {
    print_outcome(outcome);
  }
  if (!outcome.report_problem.empty()) {
    fmt::print(stderr, "error: {}\n", outcome.report_problem);
    return static_cast<int>(ExitCode::unfinished);
  }
  return static_cast<int>(ExitCode::success);
}

} // namespace ionskin::apps
