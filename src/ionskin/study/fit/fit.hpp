// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/study/fit/fit_model.hpp"
#include "ionskin/study/fit/fit_statistics.hpp"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace ionskin::study {

/// Fitted parameter with its 95 % confidence interval, in the unit of the parameter (SI).
struct FittedParameter {
  FitParameter parameter;
  /// Estimate, and limits of its interval; the limits are NaN where the data do not determine them.
  double value = 0, lower_95 = 0, upper_95 = 0;
  /// True if the value is at an end of the range of its key, where the interval has no meaning.
  bool at_bound = false;
};

/// Result of the least squares fit. Made by `fit`; `run_fit` adds the numerical error.
struct FitResult {
  std::vector<FittedParameter> parameters;
  std::vector<double> fitted; ///< prediction at the fitted values, one value per row of the data
  /// Numerical error of `fitted` per row, half the width of an error band; empty where it is not
  /// estimated.
  std::vector<double> fitted_error;
  FitStatistics statistics;
  /// True if the search met its tolerances within the allowed number of iterations.
  bool converged = false;
  int iterations = 0;
  std::vector<std::string> warnings;
};

/// Receiver of warnings for the user, one sentence each, while the fit runs.
using FitNote = std::function<void(const std::string&)>;

/// Prepares the data and the model for `fit`: removes rows that the run cannot predict, and makes
/// the model store the taxel that the data belong to. With a free `data.time_shift`, no rows are
/// removed here: `fit` removes rows after the end of the run once the shift is known.
/// Throws UserError when the case has no such signal; or when the data last longer than the run, do
/// not count their time from its start, are constant, or have too few rows.
void prepare(FitData& data, FitModel& model);

/// Fits the model to the data by nonlinear least squares with bounds (Levenberg-Marquardt, by
/// Ceres). Keys of the case vary in the logarithm of their magnitude, keys of the data linearly.
/// Derivatives are central differences, whose points are solved in parallel.
/// @param data prepared by `prepare`; with a free time shift, rows after the end of the run are
/// removed
/// @param progress receives the activity "least squares"
/// @param note receives each warning that is known before the search
/// Throws SolverError when the start has no solution, UserError when the data cannot come from the
/// model at any value of the keys (`compare_with_start`), Interrupted.
FitResult fit(FitModel& model, FitData& data, const base::ProgressCallback& progress,
              const FitNote& note);

/// Text of fit.json: estimates, statistics and counters.
/// @param seconds wall time of the fit [s]
std::string fit_json_text(const FitResult& result, const FitModel& model, const FitData& data,
                          double seconds);

/// Input of `run_fit`: a case, measured data, and the keys that are free.
struct FitRequest {
  std::string case_text, case_path;   ///< text; path for messages and relative file names
  std::vector<std::string> set_edits; ///< changes of the case, "KEY=value" each
  std::filesystem::path data_path;
  std::string column; ///< signal to fit; empty when the data hold only one that a fit can use
  std::vector<std::string> free; ///< keys of the case or of the data to fit
};

/// Options of `run_fit`, and the folder for its results.
struct FitOptions {
  std::filesystem::path folder;
  int threads = 1;
  bool overwrite = false;
  bool resume = false; ///< reuses the evaluations of an interrupted fit in the folder
  bool report = true;  ///< draws the figure
  std::string command;
  base::ProgressCallback progress = base::no_progress;
  FitNote note = [](const std::string&) {};
};

/// Fits a case to measured data and writes manifest.json, case.toml (the start), fitted.toml,
/// fit.json, fit.csv and the figure into the output folder.
/// Throws UserError before any work for everything that is wrong with the input and for a folder to
/// resume that holds another fit; later as `fit` does.
FitResult run_fit(const FitRequest& request, const FitOptions& options);

} // namespace ionskin::study
