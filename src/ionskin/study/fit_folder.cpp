// SPDX-License-Identifier: Apache-2.0
#include "ionskin/base/error.hpp"
#include "ionskin/base/timers.hpp"
#include "ionskin/results/atomic_file.hpp"
#include "ionskin/results/csv_writer.hpp"
#include "ionskin/results/manifest.hpp"
#include "ionskin/results/output_folder.hpp"
#include "ionskin/study/fit.hpp"
#include "ionskin/study/report.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace ionskin::study {
namespace {

namespace names = results::file_names;
using Json = nlohmann::ordered_json;

/// Not finite: null.
Json number(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json parameter_json(const FittedParameter& fitted, double log_error) {
  return {{"value", fitted.value},
          {"unit", fitted.parameter.unit},
          {"lower_95", number(fitted.lower_95)},
          {"upper_95", number(fitted.upper_95)},
          {"log_standard_error", number(log_error)},
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
  return table;
}

void write_fit(const FitModel& model, const FitData& data, const FitResult& result, double seconds,
               const std::filesystem::path& folder) {
  std::vector<double> values;
  for (const FittedParameter& fitted : result.parameters) {
    values.push_back(fitted.value);
  }
  results::write_text_file(folder / names::fitted_case, model.case_at(values).text);
  results::write_csv(folder / names::fit_table, fit_table(data, result));
  results::write_text_file(folder / names::fit, fit_json_text(result, model, data, seconds));
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
  json["ion_transport_solves"] = model.ion_solves();
  json["mechanics_solves"] = model.mechanics_solves();
  json["warnings"] = result.warnings;
  json["seconds"] = seconds;
  return json.dump(2) + "\n";
}

FitResult run_fit(const FitRequest& request, const FitOptions& options) {
  const double start = base::wall_time();
  FitModel model(request.case_text, request.case_path, request.set_edits, request.free,
                 {options.threads, options.use_cache, options.progress});
  FitData data = read_fit_data(request.data_path, request.column);
  prepare(data, model);
  results::prepare_output_folder(options.folder, options.overwrite
                                                     ? results::ExistingFolder::overwrite
                                                     : results::ExistingFolder::refuse);
  auto manifest = results::new_manifest(options.command, options.threads,
                                        results::content_hash(model.start_case().text));
  results::write_text_file(options.folder / names::case_text, model.start_case().text);
  results::write_manifest(options.folder / names::manifest, manifest);
  FitResult result = fit(model, data, options.progress);
  write_fit(model, data, result, base::wall_time() - start, options.folder);
  if (options.report) {
    if (const auto problem = draw_fit(options.folder)) {
      result.warnings.push_back(*problem);
    }
  }
  manifest.state = "finished";
  results::write_manifest(options.folder / names::manifest, manifest);
  return result;
}

} // namespace ionskin::study
