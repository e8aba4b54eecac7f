// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>

namespace ionskin::results {

/// One stage of a run.
struct StageRecord {
  std::string state;      ///< "running", "finished", "interrupted" or "failed"
  double wall_time = 0;   ///< [s]
  double peak_memory = 0; ///< largest resident memory of the process when the stage ended [bytes]
  std::string source;     ///< origin of what was taken over: "earlier run", "another point"; empty
                          ///< where worked here
};

/// Contents of manifest.json: where a result comes from and how far its run came. Nothing in it
/// names the machine.
struct Manifest {
  std::string command;
  std::string input_hash;        ///< of everything that decides the result, see `content_hash`
  std::string state = "running"; ///< of the whole run, as for the stages
  std::string reason;            ///< reason why the run gave up
  std::string started;           ///< UTC, ISO 8601; filled by `new_manifest`
  int threads = 1;
  std::map<std::string, StageRecord> stages;
  std::map<std::string, double> counters;
  std::string build; ///< digest of the program, empty when unknown; filled by `new_manifest`
  std::map<std::string, std::string> files; ///< digests of the results, by name; when finished
};

/// A manifest that starts now.
Manifest new_manifest(std::string command, int threads, std::string input_hash);

/// The JSON text, with the program's version, commit and compiler.
std::string manifest_text(const Manifest& manifest);
/// Writes the file atomically. Throws UserError when it cannot.
void write_manifest(const std::filesystem::path& path, const Manifest& manifest);
/// Throws UserError when the file is missing, is not a manifest of ionskin, or was changed.
Manifest read_manifest(const std::filesystem::path& path);
bool is_ionskin_manifest(const std::filesystem::path& path);

/// The digest of `base::DigestBuilder` as 32 hexadecimal digits. Tells whether two inputs differ;
/// no protection against forgery.
std::string content_hash(std::string_view content);

} // namespace ionskin::results
