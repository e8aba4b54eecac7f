// SPDX-License-Identifier: Apache-2.0
#include "study_verbs/python_verbs.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/base/system/installation.hpp"
#include "ionskin/case/schema/schema.hpp"
#include "ionskin/study/run/python_module.hpp"
#include "terminal/progress_display.hpp"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

namespace ionskin::apps {
namespace {

[[noreturn]] void throw_no_python() {
  throw UserError(base::python_interpreter() +
                  " cannot be started\n  = ionskin doctor says what is missing");
}

int run_module(const std::string& module, const std::vector<std::string>& arguments) {
  const int code =
      study::run_python_module(module, arguments, study::PythonErrors::shown).exit_code;
  if (code < 0) {
    throw_no_python();
  }
  return code;
}

/// Text of a list of numbers with ranges: "0-3,7-7".
std::string ranges(const std::vector<std::size_t>& numbers) {
  std::string text;
  for (std::size_t i = 0; i < numbers.size();) {
    std::size_t end = i + 1;
    while (end < numbers.size() && numbers[end] == numbers[end - 1] + 1) {
      ++end;
    }
    text += fmt::format("{}{}-{}", i > 0 ? "," : "", numbers[i], numbers[end - 1]);
    i = end;
  }
  return text;
}

} // namespace

int report(const ReportOptions& options) {
  std::vector<std::string> arguments{options.folder, "--progress"};
  if (options.log != LogFormat::quiet) {
    arguments.emplace_back("--tell");
  }
  if (options.claims) {
    arguments.emplace_back("--claims");
  }
  if (options.files) {
    arguments.emplace_back("--figures");
  }
  for (const std::string& figure : options.figures) {
    arguments.insert(arguments.end(), {"--figure", figure});
  }
  study::PythonOutcome outcome;
  {
    ProgressDisplay display(options.log);
    display.update("report", 0.0);
    outcome = study::run_python_module("ionskin.report", arguments, study::PythonErrors::captured,
                                       [&](double part) { display.update("report", part); });
  }
  if (outcome.exit_code < 0 && outcome.message.empty()) {
    throw_no_python();
  }
  if (outcome.exit_code != 0) {
    fmt::print(stderr, "error: {}\n",
               outcome.message.empty() ? "the report could not be made" : outcome.message);
  }
  return outcome.exit_code < 0 ? static_cast<int>(ExitCode::internal_error) : outcome.exit_code;
}

int cluster(const ClusterOptions& options) {
  std::vector<std::string> arguments{options.action,    options.folder,
                                     "--address",       options.address,
                                     "--workers",       fmt::format("{}", options.workers),
                                     "--threads",       fmt::format("{}", options.threads),
                                     "--memory",        fmt::format("{}", options.memory),
                                     "--death-timeout", fmt::format("{}", options.death_timeout)};
  if (options.tls) {
    arguments.emplace_back("--tls");
  }
  study::become_python_module("ionskin.cluster", arguments);
  throw_no_python();
}

int do_batches_on_cluster(const SweepOptions& options, const std::vector<std::size_t>& batches,
                          const std::string& progress) {
  return run_module("ionskin.cluster.sweep", {options.output, "--on", options.on, "--batches",
                                              ranges(batches), "--progress", progress});
}

int compare(const CompareOptions& options) {
  // A case may leave out what it then takes from the schema.
  nlohmann::json defaults = nlohmann::json::object();
  for (const SchemaRow& row : schema()) {
    if (!row.default_value.empty()) {
      defaults[row.key] = row.default_value;
    }
  }
  return run_module("ionskin.compare",
                    {options.first, options.second, "--tolerance",
                     fmt::format("{}", options.tolerance), "--defaults", defaults.dump()});
}

} // namespace ionskin::apps
