// SPDX-License-Identifier: Apache-2.0
#include "study_verbs/fit.hpp"

#include "command_line/study_settings.hpp"
#include "ionskin/base/error.hpp"
#include "ionskin/base/files/read_text_file.hpp"
#include "ionskin/base/system/interrupt.hpp"
#include "ionskin/study/fit/fit.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace ionskin::apps {
namespace {

/// Number of significant digits at which the ends of the 95 % interval differ.
int digits(const study::FittedParameter& fitted) {
  const double width = std::abs(fitted.upper_95 - fitted.lower_95);
  const double ratio = std::abs(fitted.value) / width;
  return std::isfinite(ratio) && ratio > 0
             ? std::clamp(2 + static_cast<int>(std::ceil(std::log10(ratio))), 6, 16)
             : 6;
}

void print_result(const study::FitResult& result, const FitOptions& options) {
  for (const auto& fitted : result.parameters) {
    const std::string unit = fitted.parameter.unit == "1" ? "" : " " + fitted.parameter.unit;
    const int places = digits(fitted);
    const std::string interval =
        std::isfinite(fitted.lower_95)
            ? fmt::format("{:.{}g} to {:.{}g}", fitted.lower_95, places, fitted.upper_95, places)
            : "not fixed by the data";
    fmt::print("{:<34} {:.{}g}{}  (95 %: {}; start {:.6g})\n", fitted.parameter.key, fitted.value,
               places, unit, interval, fitted.parameter.start);
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
    settings.note = [&display](const std::string& text) { display.tell("note: " + text); };
    result = study::run_fit(request, settings);
  }
  if (options.log != LogFormat::quiet) {
    print_result(result, options);
  }
  return static_cast<int>(ExitCode::success);
}

} // namespace ionskin::apps
