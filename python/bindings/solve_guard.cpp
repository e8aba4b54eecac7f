// SPDX-License-Identifier: Apache-2.0
#include "solve_guard.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/base/system/interrupt.hpp"

#include <atomic>
#include <chrono>
#include <string>
#include <string_view>
#include <unistd.h>

namespace ionskin::python {
namespace {

namespace py = pybind11;

/// Messages quote names and lines of files, which need not be UTF-8.
py::str message(const std::string& text) {
  PyObject* decoded =
      PyUnicode_DecodeUTF8(text.data(), static_cast<Py_ssize_t>(text.size()), "backslashreplace");
  if (decoded == nullptr) {
    throw py::error_already_set();
  }
  return py::reinterpret_steal<py::str>(decoded);
}

template <class... Arguments> void raise(const char* name, const Arguments&... arguments) {
  const py::object type = py::module_::import("ionskin.errors").attr(name);
  PyErr_SetObject(type.ptr(), type(message(arguments)...).ptr());
}

/// The process that solves now; 0 when none does.
std::atomic<pid_t> solving = 0;
std::timed_mutex one_at_a_time;
/// True while this thread is in a progress callable.
thread_local bool reporting = false;

class Reporting {
public:
  Reporting() { reporting = true; }
  ~Reporting() { reporting = false; }
  Reporting(const Reporting&) = delete;
  Reporting& operator=(const Reporting&) = delete;
};

class Solving {
public:
  Solving() { solving = getpid(); }
  ~Solving() { solving = 0; }
  Solving(const Solving&) = delete;
  Solving& operator=(const Solving&) = delete;
};

/// A copy of this process has the thread that forked alone, and would wait for the others.
void end_forked_copy() {
  if (solving != getpid()) {
    constexpr std::string_view text =
        "error: a progress callable of ionskin forked this process and did not end it\n"
        "  = end the copy with os._exit, or begin programs with subprocess\n";
    [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, text.data(), text.size());
    _exit(static_cast<int>(ExitCode::user_error));
  }
}

std::unique_lock<std::timed_mutex> wait_for_turn() {
  constexpr std::chrono::milliseconds patience(100);
  if (reporting) {
    throw UserError("a progress callable of a run cannot begin another one, which would wait for "
                    "the first\n  = begin it when the first has returned");
  }
  if (solving != 0 && solving != getpid()) {
    throw UserError("this process was forked while ionskin solved in its parent, whose threads it "
                    "lacks\n  = fork before the run begins, or start processes with "
                    "multiprocessing.get_context(\"spawn\")");
  }
  std::unique_lock lock(one_at_a_time, std::defer_lock);
  while (!lock.try_lock_for(patience)) {
    const py::gil_scoped_acquire interpreter;
    if (PyErr_CheckSignals() != 0) {
      throw py::error_already_set();
    }
  }
  return lock;
}

} // namespace

base::ProgressCallback PythonProgress::callback() {
  if (callback_.is_none()) {
    return base::no_progress;
  }
  return [this](std::string_view activity, double fraction) {
    const py::gil_scoped_acquire lock;
    const Reporting here;
    try {
      callback_(std::string(activity), fraction);
    } catch (const py::error_already_set&) {
      const std::lock_guard failure_lock(mutex_);
      failure_ = std::current_exception();
      base::request_interrupt();
    }
    end_forked_copy();
  };
}

void PythonProgress::rethrow() const {
  if (failure_) {
    std::rethrow_exception(failure_);
  }
}

void solve_unlocked(bool take_signal, const PythonProgress& progress,
                    const std::function<void()>& solve) {
  const py::gil_scoped_release unlocked;
  const std::unique_lock turn = wait_for_turn();
  const Solving now;
  const base::InterruptScope scope(take_signal);
  try {
    solve();
  } catch (const Interrupted&) {
    progress.rethrow();
    throw;
  }
  progress.rethrow();
}

void translate_errors() {
  py::register_local_exception_translator([](std::exception_ptr error) {
    try {
      std::rethrow_exception(error);
    } catch (const UserError& mistake) {
      raise("CaseError", std::string(mistake.what()));
    } catch (const SolverError& surrender) {
      raise("SolverError", std::string(surrender.what()), surrender.remedy());
    } catch (const Interrupted&) {
      PyErr_SetString(PyExc_KeyboardInterrupt,
                      "what was finished is kept; the same call with resume=True continues");
    } catch (const InternalError& mistake) {
      PyErr_SetObject(PyExc_RuntimeError, message(mistake.what()).ptr());
    }
  });
}

} // namespace ionskin::python
