// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

namespace ionskin::results {

/// What to do with a folder that already holds something.
enum class ExistingFolder {
  refuse,
  overwrite, ///< remove the files that ionskin writes, and only those
  resume     ///< keep everything
};

/// Makes the output folder of a run ready before any work. A missing or an empty folder is taken as
/// it is. `overwrite` and `resume` accept only a folder with ionskin's manifest.json, so that no
/// foreign file of the same name is lost.
/// Throws UserError when the folder holds other files, is none, or cannot be written.
void prepare_output_folder(const std::filesystem::path& folder, ExistingFolder existing);

/// Names inside the folder of a run.
namespace file_names {
inline constexpr const char* manifest = "manifest.json";
inline constexpr const char* case_text = "case.toml";
inline constexpr const char* summary = "summary.json";
inline constexpr const char* signals = "signals.csv";
inline constexpr const char* sampled = "sampled.csv";
inline constexpr const char* taxels = "taxels.csv";   ///< of a segmented top electrode
inline constexpr const char* circuit = "circuit.csv"; ///< of a circuit other than the short one
inline constexpr const char* sampled_taxels = "sampled_taxels.csv";
inline constexpr const char* sampled_circuit = "sampled_circuit.csv";
// Errors of the signals, with the same columns.
inline constexpr const char* signals_error = "signals_error.csv";
inline constexpr const char* sampled_error = "sampled_error.csv";
inline constexpr const char* taxels_error = "taxels_error.csv";
inline constexpr const char* circuit_error = "circuit_error.csv";
inline constexpr const char* impedance = "impedance.csv"; ///< of a spectrum
inline constexpr const char* fit = "fit.json";            ///< of a fit to measured data
inline constexpr const char* fit_table = "fit.csv";       ///< likewise
inline constexpr const char* fitted_case = "fitted.toml"; ///< likewise
inline constexpr const char* evaluations = "evaluations"; ///< folder of an unfinished fit
inline constexpr const char* results = "results.h5";
inline constexpr const char* checkpoint = "checkpoint.h5"; ///< of an unfinished run
inline constexpr const char* report = "report.html";
inline constexpr const char* fields = "fields";
inline constexpr const char* figures = "figures";
// Of a sweep.
inline constexpr const char* points = "points"; ///< folder of the points' folders
inline constexpr const char* sweep_table = "sweep.csv";
inline constexpr const char* sweep_signals = "sweep.h5";
} // namespace file_names

} // namespace ionskin::results
