// SPDX-License-Identifier: Apache-2.0

// The solver as Python sees it. What users meet is the package `ionskin`, which stands on these few
// functions of plain values.

#include "case_source.hpp"
#include "solve_guard.hpp"

#include "command_line/guard.hpp"
#include "command_line/threads.hpp"
#include "ionskin/base/error.hpp"
#include "ionskin/base/nearest_name.hpp"
#include "ionskin/base/system/own_build.hpp"
#include "ionskin/case/reading/read_case.hpp"
#include "ionskin/planning/cost_estimate.hpp"
#include "ionskin/planning/output_size.hpp"
#include "ionskin/planning/resources.hpp"
#include "ionskin/results/strain_file/strain_file.hpp"
#include "ionskin/study/run/run_case.hpp"
#include "ionskin/study/sweep/sweep.hpp"

#include <pybind11/stl.h>

namespace {

namespace py = pybind11;
using namespace ionskin;

using python::case_source;
using python::CaseSource;

CaseDocument read(const CaseSource& source) {
  return read_case_text(source.text, source.path, source.edits);
}

std::string unit_of(units::Dimension dimension) {
  return units::dimension_info(dimension).si_unit;
}

/// Number, list of numbers or text.
py::object python_value(const ValueRecord& record) {
  if (record.value.numbers.empty() && record.si.substr(0, 1) != "[") {
    return py::str(record.value.text);
  }
  const SchemaRow* row = find_row(key_pattern(record.key));
  if (row->type == ValueType::integer) {
    return py::int_(static_cast<long>(record.value.numbers[0]));
  }
  const bool scalar = row->type == ValueType::number || row->type == ValueType::quantity;
  return scalar ? py::cast(record.value.numbers[0]) : py::cast(record.value.numbers);
}

py::dict values(const py::handle& python_case) {
  py::dict result;
  for (const ValueRecord& record : read(case_source(python_case)).records) {
    result[py::str(record.key)] =
        py::make_tuple(python_value(record), unit_of(record.value.dimension),
                       to_string(record.origin), record.written);
  }
  return result;
}

/// SI unit of the numbers that a key takes, "1" for pure numbers, "" for texts; None when unknown.
std::optional<std::string> key_unit(const std::string& key) {
  const auto entry = list_entry(key);
  const SchemaRow* row = find_row(key_pattern(entry ? entry->list : key));
  if (row == nullptr) {
    return std::nullopt;
  }
  const bool text = row->type == ValueType::text || row->type == ValueType::choice;
  return text ? "" : unit_of(row->dimension);
}

std::string nearest_key(const std::string& key) {
  std::vector<std::string> keys;
  for (const SchemaRow& row : schema()) {
    keys.push_back(row.key);
  }
  return base::nearest_name(key, keys);
}

study::Studies studies(const std::string& only) {
  if (only == "mechanics") {
    return study::Studies::mechanics;
  }
  return only == "electrochemistry" ? study::Studies::electrochemistry : study::Studies::both;
}

/// Options that run and sweep have in common.
template <class Options>
Options common(const py::dict& settings, python::PythonProgress& progress) {
  Options options;
  options.folder = settings["output"].cast<std::string>();
  options.threads = apps::thread_count(settings["threads"].cast<int>());
  options.overwrite = settings["overwrite"].cast<bool>();
  options.resume = settings["resume"].cast<bool>();
  options.studies = studies(settings["only"].cast<std::string>());
  options.report = settings["report"].cast<bool>();
  options.command = settings["command"].cast<std::string>();
  options.progress = progress.callback();
  return options;
}

void run(const py::handle& python_case, const py::dict& settings, const py::object& callback) {
  const Case input = read(case_source(python_case)).input;
  python::PythonProgress progress(callback);
  const auto options = common<study::RunOptions>(settings, progress);
  python::solve_unlocked(settings["main_thread"].cast<bool>(), progress,
                         [&] { study::run_case(input, options); });
}

/// Estimate of what a run by one thread takes [bytes].
double memory(const py::handle& python_case) {
  const Case input = read(case_source(python_case)).input;
  return input.strain.kind == StrainSourceKind::file
             ? planning::estimate_cost(input,
                                       results::read_strain_file(input.strain.file, input.skin), 1)
                   .memory
             : planning::estimate_cost(input, 1).memory;
}

/// Estimates of what the files of a run take, and what an outcome of a study keeps of it, its
/// tables [bytes]; 0 for a strain that is given by a file, which tells how long it lasts.
std::pair<double, double> output(const py::handle& python_case) {
  const Case input = read(case_source(python_case)).input;
  return input.strain.kind == StrainSourceKind::file
             ? std::pair(0.0, 0.0)
             : std::pair(planning::expected_output(input, true), planning::expected_tables(input));
}

std::map<std::string, std::string> sweep(const py::handle& python_case,
                                         const std::vector<std::string>& over,
                                         const py::dict& settings, const py::object& callback) {
  const CaseSource base = case_source(python_case);
  study::SweepRequest request;
  request.case_path = base.path;
  request.case_text = base.text;
  request.set_edits = base.edits;
  request.over = over;
  request.samples = settings["samples"].cast<std::size_t>();
  request.sampling = settings["sampling"].cast<std::string>() == "latin"
                         ? study::Sampling::latin_hypercube
                         : study::Sampling::sobol;
  request.seed = settings["seed"].cast<std::uint64_t>();
  python::PythonProgress progress(callback);
  const auto options = common<study::SweepOptions>(settings, progress);
  study::SweepOutcome outcome;
  python::solve_unlocked(settings["main_thread"].cast<bool>(), progress,
                         [&] { outcome = study::run_sweep(study::plan_sweep(request), options); });
  return outcome.failures;
}

} // namespace

namespace ionskin::python {

CaseSource case_source(const py::handle& python_case) {
  return {python_case.attr("_original").cast<std::string>(),
          // Paths are handed over as bytes: names of files need not be UTF-8.
          py::module_::import("os").attr("fsencode")(python_case.attr("_path")).cast<std::string>(),
          python_case.attr("_edit_list")().cast<std::vector<std::string>>()};
}

} // namespace ionskin::python

PYBIND11_MODULE(_ionskin_solver, module) {
  module.doc() = "Solver of ionskin; the package `ionskin` is its face.";
  python::translate_errors();
  apps::require_vector_instructions();
  module.def("check_values", [](const py::handle& python_case) {
    const CaseSource base = case_source(python_case);
    check_values(base.text, base.path, base.edits);
  });
  module.def("case_text", [](const py::handle& python_case) {
    return read(case_source(python_case)).input.text;
  });
  module.def("values", &values);
  module.def("key_unit", &key_unit);
  module.def("nearest_key", &nearest_key);
  module.def("memory", &memory);
  module.def("output", &output);
  module.def("require_disk", [](double bytes, const std::string& folder) {
    planning::require_disk(bytes, folder);
  });
  module.def("build", [] {
    const auto build = base::own_build();
    return build ? build->hex() : std::string();
  });
  module.def("run", &run);
  module.def("sweep", &sweep);
  python::add_fit_bindings(module);
  python::add_key_bindings(module);
  python::add_table_bindings(module);
}
