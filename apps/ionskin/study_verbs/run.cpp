// SPDX-License-Identifier: Apache-2.0
#include "study_verbs/run.hpp"

#include "command_line/study_settings.hpp"
#include "ionskin/base/error.hpp"
#include "ionskin/base/percent.hpp"
#include "ionskin/base/system/interrupt.hpp"
#include "ionskin/case/reading/read_case.hpp"
#include "ionskin/planning/cost_estimate.hpp"
#include "ionskin/planning/output_size.hpp"
#include "ionskin/results/output_folder.hpp"
#include "ionskin/study/run/run_case.hpp"
#include "terminal/terminal.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace ionskin::apps {
namespace {

constexpr std::array<std::string_view, 10> headline{
    "normal_force_slide",        "mean_shear_slide",
    "peak_sampled_current_top",  "peak_sampled_current_difference",
    "rms_current_difference",    "tail_current_difference",
    "charge_identity_error",     "peak_voltage",
    "peak_open_circuit_voltage", "open_circuit_voltage_per_newton"};

study::Studies studies(const std::string& only) {
  if (only == "mechanics") {
    return study::Studies::mechanics;
  }
  return only == "electrochemistry" ? study::Studies::electrochemistry : study::Studies::both;
}

/// Announces gigabytes of output before they are written; those under a strain file follow from the
/// file.
void announce_output(const Case& input, int threads) {
  if (input.strain.kind != StrainSourceKind::file) {
    const double bytes = planning::estimate_cost(input, threads).output;
    if (const std::string size = planning::announced_output(input, bytes); !size.empty()) {
      fmt::print(stderr, "{}", paragraph("note: " + size, 2, fileno(stderr)));
    }
  }
}

/// The first few; there may be one for every instant of a long motion.
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
  for (const auto& metric : outcome.metrics) {
    if (std::find(headline.begin(), headline.end(), metric.name) != headline.end()) {
      const auto error = outcome.errors.relative.find(metric.name);
      fmt::print("{:<34} {:.6g} {}{}\n", metric.name, metric.value,
                 metric.unit == "1" ? "" : metric.unit,
                 error == outcome.errors.relative.end()
                     ? ""
                     : fmt::format("  (estimated error {})", base::percent(error->second)));
    }
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
    announce_output(input, thread_count(options.threads));
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
