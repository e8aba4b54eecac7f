// SPDX-License-Identifier: Apache-2.0
#include "study_verbs/fit.hpp"

#include "command_line/study_settings.hpp"
#include "ionskin/base/error.hpp"
#include "ionskin/base/files/read_text_file.hpp"
#include "ionskin/base/system/interrupt.hpp"
#include "ionskin/study/fit/fit.hpp"

#include <fmt/core.h>

namespace ionskin::apps {
namespace {

void print_result(const study::FitResult& result, const FitOptions& options) {
  for (const auto& fitted : result.parameters) {
    const std::string unit = fitted.parameter.unit == "1" ? "" : " " + fitted.parameter.unit;
    fmt::print("{:<34} {:.6g}{}  (95 %: {:.6g} to {:.6g}; start {:.6g})\n", fitted.parameter.key,
               fitted.value, unit, fitted.lower_95, fitted.upper_95, fitted.parameter.start);
  }
  fmt::print("explained {:.4f} of the variance; condition number {:.3g}; {} iterations\n",
             result.statistics.explained, result.statistics.condition_number, result.iterations);
  for (const std::string& warning : result.warnings) {
    fmt::print("warning: {}\n", warning);
  }
  fmt::print("fitted case: {0}/fitted.toml\nresults: {0}\n", options.output);
}

} // namespace

int fit(const FitOptions& options, const std::string& command) {
  base::install_interrupt_handler();
  const study::FitRequest request{base::read_text_file(options.case_path, "case"),
                                  options.case_path,
                                  options.set_edits,
                                  options.data_path,
                                  options.column,
                                  options.free};
  study::FitResult result;
  {
    ProgressDisplay display(options.log);
    auto settings = study_settings<study::FitOptions>(options, command, display);
    settings.resume = options.resume;
    result = study::run_fit(request, settings);
  }
  if (options.log != LogFormat::quiet) {
    print_result(result, options);
  }
  return static_cast<int>(ExitCode::success);
}

} // namespace ionskin::apps
