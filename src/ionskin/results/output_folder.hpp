// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/results/path_lock.hpp"

#include <filesystem>
#include <set>
#include <string>

namespace ionskin::results {

/// Treatment of a folder that already holds something.
enum class ExistingFolder {
  refuse,
  overwrite, ///< remove the files that ionskin wrote, and only those
  resume     ///< keep everything
};

/// The folder of the results of a run, a sweep, a fit or a spectrum while the program writes to it.
///
/// The file `.ionskin-files` in it lists what the program wrote: only that is ever removed or
/// replaced. Links are not followed: a file under the name of a link is replaced, and nothing is
/// written through the link of a folder. A lock, which goes with the process, keeps a second run
/// out.
class OutputFolder {
public:
  /// Makes the folder ready before any work. A missing or an empty folder is taken as it is.
  /// `overwrite` and `resume` accept only a folder of ionskin.
  /// @param lock `shared` where others may write other results into the folder meanwhile
  /// Throws UserError when the folder holds other files, is none, cannot be written, or is locked.
  OutputFolder(std::filesystem::path folder, ExistingFolder existing,
               LockKind lock = LockKind::exclusive);
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  const std::filesystem::path& path() const { return folder_; }
  /// Path where a file is read.
  std::filesystem::path file(const std::string& name) const { return folder_ / name; }
  /// Path where a file is written: notes it in the list, and makes its subfolder.
  /// @param name relative, such as "fields/fields.pvd"
  /// Throws UserError when a file of the user or a link is in the way.
  std::filesystem::path own(const std::string& name);
  /// Removes a file that the program wrote, if it is there.
  void remove(const std::string& name);
  /// Removes all that the program wrote, the list too, as before the work began; for work that the
  /// input ends before anything is found. What is the user's stays.
  void discard();
  /// Names of the files that the program wrote here, whether they are still there or not.
  const std::set<std::string>& owned() const { return owned_; }

private:
  void make_ready(ExistingFolder existing, LockKind lock);
  void remove_results();
  void remove_staging();

  std::filesystem::path folder_;
  PathLock lock_;
  std::set<std::string> owned_;
};

/// The lock alone, of a folder that is there. Throws UserError when another holds it.
PathLock lock_output_folder(const std::filesystem::path& folder, LockKind kind);

/// Throws UserError where a path is a link, through which nothing is written.
void refuse_link(const std::filesystem::path& path);

/// Removes the folder of the points of an earlier sweep; what is not ours stays.
void remove_points(const std::filesystem::path& points);

/// Names inside the folder of a run.
namespace file_names {
inline constexpr const char* manifest = "manifest.json";
inline constexpr const char* case_text = "case.toml";
inline constexpr const char* summary = "summary.json";
inline constexpr const char* signals = "signals.csv";
inline constexpr const char* sampled = "sampled.csv";
inline constexpr const char* taxels = "taxels.csv";   ///< of a segmented top electrode
inline constexpr const char* circuit = "circuit.csv"; ///< of a circuit other than the short one
inline constexpr const char* water = "water.csv";     ///< of a law that moves it
inline constexpr const char* sampled_taxels = "sampled_taxels.csv";
inline constexpr const char* sampled_circuit = "sampled_circuit.csv";
// Errors of the signals, with the same columns.
inline constexpr const char* signals_error = "signals_error.csv";
inline constexpr const char* sampled_error = "sampled_error.csv";
inline constexpr const char* taxels_error = "taxels_error.csv";
inline constexpr const char* circuit_error = "circuit_error.csv";
inline constexpr const char* water_error = "water_error.csv";
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
// Folders of a sweep.
inline constexpr const char* points = "points";   ///< folder of the points' folders
inline constexpr const char* staging = "staging"; ///< folder of points that are being solved
inline constexpr const char* sweep_plan = "plan.json";
inline constexpr const char* sweep_table = "sweep.csv";
inline constexpr const char* sweep_signals = "sweep.h5";
} // namespace file_names

} // namespace ionskin::results
