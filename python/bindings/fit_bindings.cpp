// SPDX-License-Identifier: Apache-2.0
#include "case_source.hpp"
#include "solve_guard.hpp"

#include "command_line/threads.hpp"
#include "ionskin/base/timers.hpp"
#include "ionskin/study/fit/fit.hpp"

#include <pybind11/stl.h>

namespace ionskin::python {
namespace {

namespace py = pybind11;

/// Progress of the mechanics goes to whichever fit runs.
struct Model {
  base::ProgressCallback progress = base::no_progress;
  study::FitModel model;

  Model(const CaseSource& source, const std::vector<std::string>& free, int threads)
      : model(source.text, source.path, source.edits, free,
              {apps::thread_count(threads), [this](std::string_view activity, double fraction) {
                 progress(activity, fraction);
               }}) {}
};

/// The text of fit.json, and the rows that were fitted: time, data, model.
py::tuple fit(Model& self, const std::string& column, const std::string& unit,
              const std::vector<double>& time, const std::vector<double>& values, bool main_thread,
              const py::object& callback) {
  PythonProgress progress(callback);
  std::string text;
  study::FitData data{column, unit, time, values};
  data.at_one_rate = study::is_at_one_rate(data);
  study::FitResult result;
  solve_unlocked(main_thread, progress, [&] {
    const double start = base::wall_time();
    study::prepare(data, self.model);
    self.progress = progress.callback();
    result = study::fit(self.model, data, self.progress, [](const std::string&) {});
    text = study::fit_json_text(result, self.model, data, base::wall_time() - start);
  });
  return py::make_tuple(text, data.time, data.values, result.fitted);
}

void fit_folder(const py::handle& python_case, const std::string& data, const std::string& column,
                const std::vector<std::string>& free, const py::dict& settings,
                const py::object& callback) {
  const CaseSource source = case_source(python_case);
  PythonProgress progress(callback);
  study::FitOptions options;
  options.folder = settings["output"].cast<std::string>();
  options.threads = apps::thread_count(settings["threads"].cast<int>());
  options.overwrite = settings["overwrite"].cast<bool>();
  options.resume = settings["resume"].cast<bool>();
  options.report = settings["report"].cast<bool>();
  options.command = settings["command"].cast<std::string>();
  options.progress = progress.callback();
  solve_unlocked(settings["main_thread"].cast<bool>(), progress, [&] {
    study::run_fit({source.text, source.path, source.edits, data, column, free}, options);
  });
}

} // namespace

void add_fit_bindings(py::module_& module) {
  module.def("fit_folder", &fit_folder);
  py::class_<Model>(module, "FitModel")
      .def(py::init(
          [](const py::handle& python_case, const std::vector<std::string>& free, int threads) {
            return std::make_unique<Model>(case_source(python_case), free, threads);
          }))
      .def("columns", [](const Model& self) { return study::fit_columns(self.model.start_case()); })
      .def("fit", &fit);
}

} // namespace ionskin::python
