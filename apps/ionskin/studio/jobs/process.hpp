// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/base/system/file_descriptor.hpp"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <string>
#include <sys/types.h>
#include <vector>

namespace ionskin::apps::studio {

/// Identity of a process that may have been started by an earlier server. It has the start time
/// beside the process number, which the system could have given to another process since.
struct ProcessId {
  pid_t pid = 0;
  std::string started; ///< from /proc: start time in ticks since boot, and id of the boot

  /// True if the process still runs.
  bool alive() const;
};

/// Identity of a running process; `started` is empty when there is no such process.
ProcessId identify(pid_t pid);

/// Path of the program ionskin: the one that started this process, or else the one beside this
/// program.
std::filesystem::path program();

/// Starts a program in a session of its own, so that it outlives this process, and returns its
/// process number. No shell is involved.
/// @param words path of the program, then its arguments
/// @param folder working folder of the program
/// @param output file of its standard output
/// @param errors file of its standard error
/// Throws std::system_error.
pid_t start_detached(const std::vector<std::string>& words, const base::FileDescriptor& folder,
                     const std::filesystem::path& output, const std::filesystem::path& errors);

/// Outcome of a program that has ended: exit code and output.
struct Outcome {
  int exit_code = -1;     ///< exit code; negative when a signal ended the program
  bool timed_out = false; ///< true if the program was ended because its time was over
  std::string output, errors;

  /// Replaces the name `given` of a file by `known` in the errors, where the program was given
  /// another name than the user knows.
  void rename(const std::string& given, const std::string& known);
};

/// Runs a program to its end with bounded time, memory and output, confined to its working folder,
/// see `Confinement`.
/// @param words path of the program, then its arguments
/// @param folder working folder of the program
/// @param time longest time; the program is ended then
/// @param memory bound of the address space [bytes]; 0 for no bound
Outcome run_to_end(const std::vector<std::string>& words, const base::FileDescriptor& folder,
                   std::chrono::seconds time, std::size_t memory);

} // namespace ionskin::apps::studio
