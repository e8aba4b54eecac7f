// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/base/error.hpp"
#include "ionskin/base/timers.hpp"
#include "ionskin/results/manifest.hpp"
#include "ionskin/study/run_case.hpp"

#include <filesystem>
#include <string>

namespace ionskin::study {

/// The folder of one run and its manifest, which tells at any time what is finished.
class RunFolder {
public:
  /// Makes the folder ready and writes case.toml and the manifest. Throws UserError when the folder
  /// is taken, cannot be written, or holds another case than the one to resume.
  RunFolder(const Case& input, const RunOptions& options);

  std::filesystem::path file(const char* name) const { return folder_ / name; }
  const std::filesystem::path& path() const { return folder_; }
  /// True when an earlier run of the same case finished this stage.
  bool was_finished(const std::string& stage) const;

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
      end(name, "interrupted", base::wall_time() - start);
      throw;
    } catch (...) {
      end(name, "failed", base::wall_time() - start);
      throw;
    }
  }

  /// Notes a stage that was worked elsewhere.
  void add_finished(const std::string& stage, double seconds) { end(stage, "finished", seconds); }
  void set_counter(const std::string& name, double value) { manifest_.counters[name] = value; }
  /// Marks the whole run as finished, or as failed where its results do not pass their audits.
  void finish(bool sound = true);
  const results::Manifest& manifest() const { return manifest_; }

private:
  void begin(const std::string& stage);
  void end(const std::string& stage, const std::string& state, double seconds);
  void write_manifest() const;

  std::filesystem::path folder_;
  results::Manifest manifest_;
  results::Manifest earlier_;
};

/// Hash of a case: of its text, and of the waypoints, heights and strain that it takes from files.
/// Throws UserError when the strain file cannot be read.
std::string input_hash(const Case& input);

/// Hash of everything that decides Study 1.
std::string mechanics_hash(const Case& input);

} // namespace ionskin::study
