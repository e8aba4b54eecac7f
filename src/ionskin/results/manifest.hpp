// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>

namespace ionskin::results {

/// Record of one stage of a run ("mechanics", "strain", "electrochemistry", "output") in its
/// manifest.
struct StageRecord {
  std::string state;      ///< "running", "finished", "interrupted" or "failed"
  double wall_time = 0;   ///< [s]
  double peak_memory = 0; ///< largest resident memory of the process when the stage ended [bytes]
  /// Origin of a stage that was reused rather than computed: "earlier run" or "another point" of
  /// the sweep; empty for a stage that this run computed.
  std::string source;
};

/// Contents of manifest.json: the input and program that a result comes from, and how far its run
/// got. It holds nothing that identifies the machine.
struct Manifest {
  std::string command;           ///< command line
  std::string input_hash;        ///< `content_hash` of everything that decides the result
  std::string state = "running"; ///< state of the whole run, as for `StageRecord::state`
  std::string reason;            ///< reason why the run gave up; empty otherwise
  std::string started;           ///< UTC, ISO 8601; set by `new_manifest`
  int threads = 1;
  std::map<std::string, StageRecord> stages; ///< by name
  std::map<std::string, double> counters;    ///< numbers for the record, such as "time_steps"
  std::string build; ///< digest of the program, empty when unknown; set by `new_manifest`
  /// Digests of the result files by name, from which later changes are found; empty until the run
  /// has finished.
  std::map<std::string, std::string> files;
};

/// Creates the manifest of a run that starts now, with its start time and the digest of this
/// program.
Manifest new_manifest(std::string command, int threads, std::string input_hash);

/// Formats a manifest as JSON text. The text also holds the program's version, commit and compiler,
/// and a digest of itself.
std::string manifest_text(const Manifest& manifest);
/// Writes `manifest_text` to a file, atomically. Throws UserError when the file cannot be written.
void write_manifest(const std::filesystem::path& path, const Manifest& manifest);
/// Reads a manifest. Throws UserError when the file is missing, is not a manifest of ionskin, or
/// was changed since ionskin wrote it.
Manifest read_manifest(const std::filesystem::path& path);
/// True if the file can be read and names ionskin as the program that wrote it; changes to it are
/// not looked for.
bool is_ionskin_manifest(const std::filesystem::path& path);

/// Digest of `content` by `base::DigestBuilder`, as 32 hexadecimal digits. It shows whether two
/// inputs differ, but does not protect against forgery.
std::string content_hash(std::string_view content);

} // namespace ionskin::results
