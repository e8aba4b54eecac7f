// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/results/path_lock.hpp"

#include <filesystem>
#include <set>
#include <string>

namespace ionskin::results {

/// Treatment of an output folder that already holds files.
enum class ExistingFolder {
  refuse,    ///< throw UserError
  overwrite, ///< remove the files that ionskin wrote there, and no others
  resume     ///< keep all files
};

/// Output folder of a run, a sweep, a fit or an impedance spectrum, locked while the program writes
/// to it.
///
/// The list file `.ionskin-files` in the folder names the files that the program wrote; no other
/// file is ever removed or replaced. Symbolic links are not followed: a link under the name of a
/// result is replaced, and nothing is written through a link to a folder. The lock keeps other runs
/// out and ends with the process.
class OutputFolder {
public:
  /// Locks and prepares the folder before any work; a missing folder is created. `overwrite` and
  /// `resume` accept only an empty folder or one that ionskin wrote.
  /// @param lock `shared` if other processes may write other results into the folder meanwhile
  /// Throws UserError when the folder holds other files, is a file, cannot be written, or is
  /// locked.
  OutputFolder(std::filesystem::path folder, ExistingFolder existing,
               LockKind lock = LockKind::exclusive);
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  const std::filesystem::path& path() const { return folder_; }
  /// Path of a file to read.
  /// @param name relative to the folder
  std::filesystem::path file(const std::string& name) const { return folder_ / name; }
  /// Path of a file to write. Adds its name to the list file and creates its subfolder first.
  /// @param name relative to the folder, such as "fields/fields.pvd"
  /// Throws UserError when a user's file or a link is in the way.
  std::filesystem::path own(const std::string& name);
  /// Removes a file that the program wrote; does nothing if it does not exist or is a user's.
  void remove(const std::string& name);
  /// Removes all files that the program wrote, and the list file, so that only users' files remain.
  /// Called when an error in the input ends the work before it has any result.
  void discard();
  /// Names of the files that the program wrote here, including files that are gone since.
  const std::set<std::string>& owned() const { return owned_; }

private:
  void make_ready(ExistingFolder existing, LockKind lock);
  void remove_results();
  void remove_staging();

  std::filesystem::path folder_;
  PathLock lock_;
  std::set<std::string> owned_;
};

/// Locks an existing output folder without preparing it. Throws UserError when another process
/// holds the lock.
PathLock lock_output_folder(const std::filesystem::path& folder, LockKind kind);

/// Throws UserError when `path` is a symbolic link, since ionskin writes nothing through links.
void refuse_link(const std::filesystem::path& path);

/// Removes the results of an earlier sweep: in each subfolder of `points` that ionskin wrote, the
/// files that it wrote. Folders are removed once they are empty; users' files stay.
void remove_points(const std::filesystem::path& points);

/// Names of files and subfolders in an output folder.
namespace file_names {
inline constexpr const char* manifest = "manifest.json";
inline constexpr const char* case_text = "case.toml";
inline constexpr const char* summary = "summary.json";
inline constexpr const char* signals = "signals.csv";
inline constexpr const char* sampled = "sampled.csv";
inline constexpr const char* taxels = "taxels.csv";   ///< written for a segmented top electrode
inline constexpr const char* circuit = "circuit.csv"; ///< written unless the electrodes are shorted
inline constexpr const char* water = "water.csv";     ///< written by coupling laws that move water
inline constexpr const char* sampled_taxels = "sampled_taxels.csv";
inline constexpr const char* sampled_circuit = "sampled_circuit.csv";
// Errors of the signals, with the same columns.
inline constexpr const char* signals_error = "signals_error.csv";
inline constexpr const char* sampled_error = "sampled_error.csv";
inline constexpr const char* taxels_error = "taxels_error.csv";
inline constexpr const char* circuit_error = "circuit_error.csv";
inline constexpr const char* water_error = "water_error.csv";
inline constexpr const char* impedance = "impedance.csv"; ///< impedance spectrum
inline constexpr const char* fit = "fit.json";            ///< result of a fit to measured data
inline constexpr const char* fit_table = "fit.csv";       ///< table of a fit to measured data
inline constexpr const char* fitted_case = "fitted.toml"; ///< case with the fitted parameters
inline constexpr const char* evaluations = "evaluations"; ///< folder of an unfinished fit
inline constexpr const char* results = "results.h5";
inline constexpr const char* checkpoint = "checkpoint.h5"; ///< state of an unfinished run
inline constexpr const char* report = "report.html";
inline constexpr const char* fields = "fields";
inline constexpr const char* figures = "figures";
// Folders of a sweep.
inline constexpr const char* points = "points";   ///< folder with one output folder per point
inline constexpr const char* staging = "staging"; ///< folder of the points that are being solved
inline constexpr const char* sweep_plan = "plan.json";
inline constexpr const char* sweep_table = "sweep.csv";
inline constexpr const char* sweep_signals = "sweep.h5";
} // namespace file_names

} // namespace ionskin::results
