// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/study/fit/fit_model.hpp"
#include "ionskin/study/fit/fit_statistics.hpp"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace ionskin::study {

/// One parameter as the fit leaves it, with its 95 % confidence interval [SI].
struct FittedParameter {
  FitParameter parameter;
  double value = 0, lower_95 = 0, upper_95 = 0; ///< no numbers where the data do not tell them
  bool at_bound = false;                        ///< the range of the key holds it
};

/// Result of the least squares.
struct FitResult {
  std::vector<FittedParameter> parameters;
  std::vector<double> fitted; ///< the model at each row of the data
  /// Stated numerical error of `fitted` per row; empty where it is not estimated.
  std::vector<double> fitted_error;
  FitStatistics statistics;
  bool converged = false;
  int iterations = 0;
  std::vector<std::string> warnings;
};

/// Receiver of notes for the user while the fit runs.
using FitNote = std::function<void(const std::string&)>;

/// Drops rows that the run cannot answer. Throws UserError when the case has no such signal, the
/// data last longer than the run, do not count their time from its beginning, are constant, or too
/// few rows are left. With a free `data.time_shift` the times are looked at by `fit`.
void prepare(FitData& data, FitModel& model);

/// Fits the model to the data by least squares in the logarithms of the parameters
/// (Levenberg-Marquardt with bounds, by Ceres), and linearly in what the data free of their own.
/// Derivatives are central differences whose points run side by side.
/// @param data prepared; rows that lie behind the run by a free shift are dropped
/// @param note called with each warning that is known before the search
/// Throws SolverError when the start has no solution, UserError when the data cannot come from the
/// model at any value of the keys (`compare_with_start`), Interrupted.
FitResult fit(FitModel& model, FitData& data, const base::ProgressCallback& progress,
              const FitNote& note);

/// Estimates, statistics and counters as the JSON text of fit.json.
/// @param seconds the fit took
std::string fit_json_text(const FitResult& result, const FitModel& model, const FitData& data,
                          double seconds);

/// Question of `ionskin fit`: a case, measured data, and the keys that are free.
struct FitRequest {
  std::string case_text, case_path; ///< the path names it and anchors the files it names
  std::vector<std::string> set_edits;
  std::filesystem::path data_path;
  std::string column; ///< empty when the data hold one that a fit can take
  std::vector<std::string> free;
};

/// Options of a fit.
struct FitOptions {
  std::filesystem::path folder;
  int threads = 1;
  bool overwrite = false;
  bool resume = false; ///< take up the evaluations of an interrupted fit in the folder
  bool report = true;  ///< draw the figure
  std::string command;
  base::ProgressCallback progress = base::no_progress;
  FitNote note = [](const std::string&) {};
};

/// Fits and writes manifest.json, case.toml (the start), fitted.toml, fit.json, fit.csv and the
/// figure. All that is wrong with the input is found before any work (UserError), and so is a
/// folder to resume that holds another fit.
FitResult run_fit(const FitRequest& request, const FitOptions& options);

} // namespace ionskin::study
