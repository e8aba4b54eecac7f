// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/base/error.hpp"
#include "ionskin/base/timers.hpp"
#include "ionskin/results/manifest.hpp"
#include "ionskin/results/output_folder.hpp"
#include "ionskin/study/run/run_case.hpp"

#include <exception>
#include <filesystem>
#include <string>
#include <vector>

namespace ionskin::study {

/// Output folder of one run with its manifest (manifest.json), which records at any time which
/// stages of the work are finished. `run_case` and the points of a sweep work through it.
class RunFolder {
public:
  /// Prepares the output folder and writes case.toml and the manifest. Finished stages of an
  /// earlier run are taken from its manifest only if the same build of the program wrote it.
  /// @param options folder, treatment of earlier results, threads and command
  /// Throws UserError when the folder is in use, cannot be written, or, with `resume`, holds
  /// another case.
  RunFolder(const Case& input, const RunOptions& options);

  /// Path from which a file of the run is read.
  std::filesystem::path file(const char* name) const { return folder_.file(name); }
  /// Path to which a file of the run is written; registers the file as one of the program's.
  std::filesystem::path own(const char* name) { return folder_.own(name); }
  results::OutputFolder& output() { return folder_; }
  const std::filesystem::path& path() const { return folder_.path(); }
  /// True if an earlier run of the same case finished this stage.
  bool was_finished(const std::string& stage) const;
  /// True if a sealed file (one that ends with a digest of its bytes and of the program's build) is
  /// there and intact. Adds a note for the user if the file is damaged.
  bool holds(const char* name);
  /// True if an earlier run finished completely and its result files are unchanged.
  bool is_complete() const { return complete_; }
  /// Adds a note for the user, a sentence on a problem with files that were found in the folder.
  void note(const std::string& text);
  const std::vector<std::string>& notes() const { return notes_; }

  /// Runs a part of the work as a named stage. Records the stage's state, wall time and peak memory
  /// in the manifest, also when the work throws, and returns the result of `work()`.
  /// Throws what `work` throws.
  template <class Work> auto stage(const std::string& name, Work&& work) {
    const double start = base::wall_time();
    begin(name);
    try {
      auto result = work();
      end(name, "finished", base::wall_time() - start);
      return result;
    } catch (const Interrupted&) {
      give_up(name, "interrupted", base::wall_time() - start);
      throw;
    } catch (const SolverError& error) {
      manifest_.reason = std::string(error.what()) + "; remedy: " + error.remedy();
      give_up(name, "failed", base::wall_time() - start);
      throw;
    } catch (const std::exception& error) {
      manifest_.reason = error.what();
      give_up(name, "failed", base::wall_time() - start);
      throw;
    }
  }

  /// Records a stage as finished that was worked elsewhere.
  /// @param seconds wall time of the stage [s]
  /// @param source origin of its results, such as "another point"; empty if they were not copied
  void add_finished(const std::string& stage, double seconds, const std::string& source = "");
  /// Records a stage as finished by an earlier run, with its wall time if the earlier manifest has
  /// it.
  void keep_finished(const std::string& stage);
  /// Sets a named number in the manifest; written with the next change of state.
  void set_counter(const std::string& name, double value) { manifest_.counters[name] = value; }
  /// Marks the whole run as finished and records the digests of its result files.
  /// @param sound false if the results fail an audit: marks the run as failed instead
  void finish(bool sound = true);
  /// Marks the whole run as failed, for a reason given as a sentence.
  void fail(const std::string& reason);
  /// Sets the state of the whole run: "planned" or "interrupted".
  void set_state(const std::string& state);
  const results::Manifest& manifest() const { return manifest_; }

private:
  void begin(const std::string& stage);
  void end(const std::string& stage, const std::string& state, double seconds);
  /// Records the end of a stage as `end` does, but ignores a manifest that cannot be written: the
  /// error that ended the stage matters more.
  void give_up(const std::string& stage, const std::string& state, double seconds);
  void take_up(const Case& input);
  bool has_all_results() const;
  void write_manifest();

  results::OutputFolder folder_;
  std::vector<std::string> notes_;
  bool complete_ = false;
  results::Manifest manifest_;
  results::Manifest earlier_;
};

/// True if a folder holds a finished run of a case by this build of the program, with all result
/// files unchanged. Takes no lock.
/// @param hash `input_hash` of the case
/// @param studies `mechanics`: a run of Study 1 is enough
bool holds_finished_run(const std::filesystem::path& folder, const std::string& hash,
                        Studies studies);

/// Hash of everything that decides the results of a case: its text, its values including those of
/// material presets and defaults, and the contents of waypoint, height map and strain files that it
/// names.
/// Throws UserError when the strain file cannot be read.
std::string input_hash(const Case& input);

/// Hash of everything that decides the results of Study 1. Cases that differ only in what Study 1
/// does not see, such as the diffusivity of the ions, have the same one.
std::string mechanics_hash(const Case& input);

} // namespace ionskin::study
