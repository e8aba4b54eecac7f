// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace ionskin::study {

/// Outcome of a module of the Python package.
struct PythonOutcome {
  int exit_code = 0;   ///< negative when the interpreter cannot be started or is killed
  std::string message; ///< its last one on standard error, where that was captured

  /// True if a library that the module imports is not there.
  bool lacks_library() const;
};

/// Destination of Python's messages.
enum class PythonErrors { shown, captured };

/// Told the finished part, in [0, 1], when a module says "progress PART" in a line of its own on
/// standard error.
using PythonProgress = std::function<void(double)>;

/// Runs a module of ionskin's Python package with these arguments and waits for it. The interpreter
/// is in its isolated mode: neither the working folder nor PYTHONPATH and its kin decide what is
/// imported. The package stands in the folder $IONSKIN_PYTHON_PATH, or where it was built.
/// @param errors whether standard error goes to the terminal or into the outcome
/// @param progress heard of errors that are captured
PythonOutcome run_python_module(const std::string& module,
                                const std::vector<std::string>& arguments, PythonErrors errors,
                                const PythonProgress& progress = {});

/// Replaces this process by a module of the package; returns only where that is not possible.
void become_python_module(const std::string& module, const std::vector<std::string>& arguments);

} // namespace ionskin::study
