// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/run/report.hpp"

#include "ionskin/base/system/installation.hpp"

#include <fmt/core.h>

namespace ionskin::study {
namespace {

std::string reason_of(const PythonOutcome& outcome) {
  if (outcome.message.empty()) {
    return outcome.exit_code < 0 ? base::python_interpreter() + " cannot be started or was ended"
                                 : fmt::format("its script ended with {}", outcome.exit_code);
  }
  return outcome.message;
}

/// Runs a Python module that draws something.
/// @param product name of what the module makes, for messages
/// @param again instruction that makes it again, for messages
/// @returns reason of a failure with its remedy; empty on success
std::optional<std::string> draw(const std::string& module,
                                const std::vector<std::string>& arguments,
                                const std::string& product, const std::string& again,
                                const PythonProgress& progress = {}) {
  const PythonOutcome outcome =
      run_python_module(module, arguments, PythonErrors::captured, progress);
  if (outcome.exit_code == 0) {
    return std::nullopt;
  }
  const bool not_installed = outcome.lacks_library() || outcome.exit_code < 0;
  return fmt::format(
      "No {} was made: {}. The results do not depend on it. Remedy: {}, then {}", product,
      reason_of(outcome),
      not_installed ? "install python3-numpy, python3-h5py, python3-matplotlib and python3-jinja2 "
                      "(ionskin doctor says what is missing)"
                    : "mend what the reason names",
      again);
}

} // namespace

std::optional<std::string> make_report(const std::filesystem::path& folder, bool figures,
                                       const PythonProgress& progress) {
  std::vector<std::string> arguments{folder.string(), "--progress"};
  if (figures) {
    arguments.emplace_back("--figures");
  }
  return draw("ionskin.report", arguments, "report",
              "run: ionskin report " + folder.string() + (figures ? " --figures" : ""), progress);
}

std::optional<std::string> draw_impedance(const std::filesystem::path& folder) {
  return draw("ionskin.impedance", {folder.string()}, "figure",
              "give the command again with --overwrite");
}

std::optional<std::string> draw_fit(const std::filesystem::path& folder) {
  return draw("ionskin.drawing.fit_figure", {folder.string()}, "figure",
              "give the command again with --overwrite");
}

} // namespace ionskin::study
