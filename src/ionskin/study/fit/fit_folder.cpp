// SPDX-License-Identifier: Apache-2.0
#include "ionskin/base/error.hpp"
#include "ionskin/base/files/atomic_file.hpp"
#include "ionskin/base/timers.hpp"
#include "ionskin/results/csv_writer.hpp"
#include "ionskin/results/manifest.hpp"
#include "ionskin/results/output_folder.hpp"
#include "ionskin/study/fit/fit.hpp"
#include "ionskin/study/fit/fitted_case.hpp"
#include "ionskin/study/run/report.hpp"
#include "ionskin/study/run/run_folder.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace ionskin::study {
namespace {

namespace names = results::file_names;
using Json = nlohmann::ordered_json;

/// JSON number; null for NaN and infinity.
Json number(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json parameter_json(const FittedParameter& fitted, double log_error) {
  return {
      {"value", fitted.value},
      {"unit", fitted.parameter.unit},
      {"lower_95", number(fitted.lower_95)},
      {"upper_95", number(fitted.upper_95)},
      {"log_standard_error", is_data_key(fitted.parameter.key) ? Json(nullptr) : number(log_error)},
      {"start", fitted.parameter.start},
      {"at_bound", fitted.at_bound}};
}

readout::SignalTable fit_table(const FitData& data, const FitResult& result) {
  std::vector<double> residual;
  for (std::size_t row = 0; row < data.values.size(); ++row) {
    residual.push_back(data.values[row] - result.fitted[row]);
  }
  readout::SignalTable table;
  table.columns = {{"time", "s", data.time},
                   {data.column + "_measured", data.unit, data.values},
                   {data.column + "_fitted", data.unit, result.fitted},
                   {data.column + "_residual", data.unit, residual}};
  if (!result.fitted_error.empty()) {
    table.columns.push_back({data.column + "_fitted_error", data.unit, result.fitted_error});
  }
  return table;
}

std::vector<double> fitted_values(const FitResult& result) {
  std::vector<double> values;
  for (const FittedParameter& fitted : result.parameters) {
    values.push_back(fitted.value);
  }
  return values;
}

/// Adds the numerical error of the fitted curve. If it cannot be estimated, the fit keeps its
/// result and warns.
void add_errors(FitModel& model, const FitData& data, FitResult& result) {
  std::string reason = "the mechanics has no solution on a mesh of twice the size";
  try {
    if (model.start_case().numerics.error_estimate) {
      result.fitted_error = model.errors(data, fitted_values(result));
    } else {
      reason = "numerics.error_estimate is off";
    }
  } catch (const SolverError& error) {
    reason = std::string("on a mesh of twice the size ") + error.what();
  }
  if (result.fitted_error.empty()) {
    result.warnings.push_back(
        "The numerical error of the fitted curve is not estimated: " + reason + ".");
  }
}

void write_fit(const std::string& data_name, const FitModel& model, const FitData& data,
               const FitResult& result, double seconds, results::OutputFolder& folder) {
  base::write_text_file(folder.own(names::fitted_case),
                        fitted_case_text(model, fitted_values(result), data_name));
  results::write_csv(folder.own(names::fit_table), fit_table(data, result));
  base::write_text_file(folder.own(names::fit), fit_json_text(result, model, data, seconds));
}

/// Hash of everything that decides the evaluations of a fit.
std::string fit_hash(const FitModel& model, const FitData& data) {
  std::string text = input_hash(model.start_case());
  for (const FitParameter& parameter : model.parameters()) {
    text += " free " + parameter.key;
  }
  text += fmt::format(" data {} {} {}", data.column, data.time, data.values);
  return results::content_hash(text);
}

void require_same_fit(const std::filesystem::path& folder, const std::string& hash) {
  const auto path = folder / names::manifest;
  if (std::filesystem::exists(path) && results::read_manifest(path).input_hash != hash) {
    throw UserError(
        fmt::format("{} holds another fit than the one to resume: the case, a --set edit, the data "
                    "or the free keys differ\n  = give the same ones, choose another folder, or "
                    "replace its results with --overwrite",
                    folder.string()));
  }
}

results::ExistingFolder existing_folder(const FitOptions& options) {
  using results::ExistingFolder;
  const auto otherwise = options.resume ? ExistingFolder::resume : ExistingFolder::refuse;
  return options.overwrite ? ExistingFolder::overwrite : otherwise;
}

} // namespace

std::string fit_json_text(const FitResult& result, const FitModel& model, const FitData& data,
                          double seconds) {
  const FitStatistics& statistics = result.statistics;
  Json json;
  for (std::size_t i = 0; i < result.parameters.size(); ++i) {
    json["parameters"][result.parameters[i].parameter.key] =
        parameter_json(result.parameters[i], statistics.log_error[i]);
  }
  json["correlation"] = statistics.correlation;
  json["condition_number"] = number(statistics.condition_number);
  json["column"] = data.column;
  json["rows"] = data.values.size();
  json["degrees_of_freedom"] = statistics.degrees_of_freedom;
  json["residual_deviation"] = {{"value", number(statistics.residual_deviation)},
                                {"unit", data.unit}};
  json["explained"] = number(statistics.explained);
  json["residual_lag_correlation"] = number(statistics.lag_correlation);
  json["converged"] = result.converged;
  json["iterations"] = result.iterations;
  json["evaluations_taken_up"] = model.evaluations_taken_up();
  json["ion_transport_solves"] = model.ion_solves();
  json["mechanics_solves"] = model.mechanics_solves();
  json["warnings"] = result.warnings;
  json["seconds"] = seconds;
  // Names of files need not be UTF-8, as JSON must.
  return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

FitResult run_fit(const FitRequest& request, const FitOptions& options) {
  const double start = base::wall_time();
  FitModel model(request.case_text, request.case_path, request.set_edits, request.free,
                 {options.threads, options.progress});
  FitData data = read_fit_data(request.data_path, fit_columns(model.start_case()), request.column);
  prepare(data, model);
  const std::string hash = fit_hash(model, data);
  results::OutputFolder folder(options.folder, existing_folder(options));
  if (options.resume) {
    require_same_fit(options.folder, hash);
  }
  auto manifest = results::new_manifest(options.command, options.threads, hash);
  base::write_text_file(folder.own(names::case_text), model.start_case().text);
  const auto note_state = [&](const char* state) {
    manifest.state = state;
    results::write_manifest(folder.own(names::manifest), manifest);
  };
  results::write_manifest(folder.own(names::manifest), manifest);
  FitLog log(folder);
  model.keep_answers_in(log);
  FitResult result;
  try {
    result = fit(model, data, options.progress, options.note);
    add_errors(model, data, result);
  } catch (const Interrupted&) {
    note_state("interrupted");
    throw;
  } catch (const UserError&) { // a fault of the data: nothing that a next fit could reuse
    folder.discard();
    throw;
  } catch (...) {
    note_state("failed");
    throw;
  }
  write_fit(request.data_path.filename().string(), model, data, result, base::wall_time() - start,
            folder);
  if (options.report) {
    if (const auto problem = draw_fit(options.folder)) {
      result.warnings.push_back(*problem);
    }
  }
  note_state("finished");
  log.remove();
  return result;
}

} // namespace ionskin::study
