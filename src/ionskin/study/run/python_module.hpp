// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace ionskin::study {

/// Outcome of a run of a Python module, made by `run_python_module`.
struct PythonOutcome {
  /// Exit status of the interpreter; negative when it cannot be started or is killed.
  int exit_code = 0;
  /// Last message on standard error as one line; empty where standard error was not captured.
  std::string message;

  /// True if a library that the module imports is not installed.
  bool lacks_library() const;
};

/// Destination of the module's standard error: the terminal (`shown`) or `PythonOutcome::message`
/// (`captured`).
enum class PythonErrors { shown, captured };

/// Receiver of the finished fraction in [0, 1], called when a module writes "progress FRACTION" as
/// a line of its own to standard error.
using PythonProgress = std::function<void(double)>;

/// Runs a module of ionskin's Python package and waits for its end. The interpreter runs in its
/// isolated mode: neither the working folder nor environment variables such as PYTHONPATH decide
/// what is imported. The package is taken from the folder $IONSKIN_PYTHON_PATH, or from where it
/// was built.
/// @param module dotted name, such as "ionskin.report"
/// @param arguments of its command line
/// @param errors where standard error goes
/// @param progress receives progress lines, with captured errors only; may be empty
PythonOutcome run_python_module(const std::string& module,
                                const std::vector<std::string>& arguments, PythonErrors errors,
                                const PythonProgress& progress = {});

/// Replaces this process by a module of ionskin's Python package (exec), started as in
/// `run_python_module`. Returns only if that fails.
/// @param module dotted name, such as "ionskin.report"
/// @param arguments of its command line
void become_python_module(const std::string& module, const std::vector<std::string>& arguments);

} // namespace ionskin::study
