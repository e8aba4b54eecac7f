// SPDX-License-Identifier: Apache-2.0
#include "solve_guard.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/base/interrupt.hpp"

#include <cblas.h>

#include <string>

namespace ionskin::python {
namespace {

namespace py = pybind11;

/// Solvers set the number of threads of OpenBLAS to 1.
class BlasThreads {
public:
  BlasThreads() = default;
  ~BlasThreads() { openblas_set_num_threads(former_); }
  BlasThreads(const BlasThreads&) = delete;
  BlasThreads& operator=(const BlasThreads&) = delete;

private:
  int former_ = openblas_get_num_threads();
};

template <class... Arguments> void raise(const char* name, const Arguments&... arguments) {
  const py::object type = py::module_::import("ionskin.errors").attr(name);
  PyErr_SetObject(type.ptr(), type(arguments...).ptr());
}

} // namespace

base::ProgressCallback PythonProgress::callback() {
  if (callback_.is_none()) {
    return base::no_progress;
  }
  return [this](std::string_view activity, double fraction) {
    const py::gil_scoped_acquire lock;
    try {
      callback_(std::string(activity), fraction);
    } catch (const py::error_already_set&) {
      const std::lock_guard failure_lock(mutex_);
      failure_ = std::current_exception();
      base::request_interrupt();
    }
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
  static std::mutex one_at_a_time;
  const std::lock_guard lock(one_at_a_time);
  const BlasThreads blas;
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
                      "what was finished is kept; the same call with resume=True goes on");
    }
  });
}

} // namespace ionskin::python
