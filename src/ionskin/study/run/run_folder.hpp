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

/// The folder of one run and its manifest, which tells at any time what is finished.
class RunFolder {
public:
  /// Makes the folder ready and writes case.toml and the manifest. Throws UserError when the folder
  /// is taken, cannot be written, or holds another case than the one to resume. What another build
  /// of the program left there is not taken up.
  RunFolder(const Case& input, const RunOptions& options);

  /// Path where a file is read.
  std::filesystem::path file(const char* name) const { return folder_.file(name); }
  /// Path where a file is written.
  std::filesystem::path own(const char* name) { return folder_.own(name); }
  results::OutputFolder& output() { return folder_; }
  const std::filesystem::path& path() const { return folder_.path(); }
  /// True when an earlier run of the same case finished this stage.
  bool was_finished(const std::string& stage) const;
  /// True when a sealed file that an earlier run left is whole; a damaged one leaves a note.
  bool holds(const char* name);
  /// True when an earlier run finished and all its results are there, as they were written.
  bool is_complete() const { return complete_; }
  /// Notes what went wrong with what was there, as sentences.
  void note(const std::string& text);
  const std::vector<std::string>& notes() const { return notes_; }

  /// Runs a part of the work as a named stage: its wall time and peak memory go into the manifest,
  /// and its state, whatever way it ends.
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

  /// Notes a stage that was worked elsewhere, and what it is taken from, if it is read from there.
  void add_finished(const std::string& stage, double seconds, const std::string& source = "");
  /// Notes a stage that an earlier run finished, with its time if the manifest knows it.
  void keep_finished(const std::string& stage);
  void set_counter(const std::string& name, double value) { manifest_.counters[name] = value; }
  /// Marks the whole run as finished, with the digests of its results, or as failed where its
  /// results do not pass their audits.
  void finish(bool sound = true);
  /// Marks the run as failed, for a reason.
  void fail(const std::string& reason);
  /// Notes how far the whole run is: "planned" or "interrupted".
  void set_state(const std::string& state);
  const results::Manifest& manifest() const { return manifest_; }

private:
  void begin(const std::string& stage);
  void end(const std::string& stage, const std::string& state, double seconds);
  /// Gives up as `end` does; the reason to give up matters more than a manifest that cannot be
  /// written.
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

/// True if a folder holds a finished run of this case by this build, with all its results as they
/// were written. Takes no lock.
/// @param hash of the case, see `input_hash`
bool holds_finished_run(const std::filesystem::path& folder, const std::string& hash,
                        Studies studies);

/// Hash of a case: of its text, of its values with those of material presets and defaults, and of
/// the waypoints, heights and strain that it takes from files. Throws UserError when the strain
/// file cannot be read.
std::string input_hash(const Case& input);

/// Hash of everything that decides Study 1.
std::string mechanics_hash(const Case& input);

} // namespace ionskin::study
