// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/base/progress.hpp"

#include <pybind11/pybind11.h>

#include <exception>
#include <functional>
#include <mutex>

namespace ionskin::python {

/// Hands progress to a Python callable. When that raises, the solve is asked to stop.
class PythonProgress {
public:
  /// @param callback takes (activity: str, fraction: float), or None
  explicit PythonProgress(pybind11::object callback) : callback_(std::move(callback)) {}

  base::ProgressCallback callback();
  /// Throws again what the callable raised; call it with or without the interpreter's lock.
  void rethrow() const;

private:
  pybind11::object callback_;
  std::mutex mutex_;
  std::exception_ptr failure_;
};

/// Runs a solve without the interpreter's lock, one at a time in this process: another one waits,
/// which Ctrl-C ends. With `take_signal` SIGINT stops the solve. Throws UserError where waiting
/// would never end: inside a progress callable, and in a process that was forked while its parent
/// solved.
void solve_unlocked(bool take_signal, const PythonProgress& progress,
                    const std::function<void()>& solve);

/// Turns the errors of ionskin into those of the package.
void translate_errors();

} // namespace ionskin::python
