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

/// A process that may have been started by an earlier server: its number alone could have been
/// given to another one since.
struct ProcessId {
  pid_t pid = 0;
  std::string started; ///< of /proc: ticks since boot, and which boot

  bool alive() const;
};

/// Identity of a process that runs now; `started` is empty when there is none.
ProcessId identify(pid_t pid);

/// The ionskin program that became this one, or else the one beside it.
std::filesystem::path program();

/// Starts a program in a session of its own, so that it outlives this one. No shell is involved.
/// @param words the program's path, then its arguments
/// @param folder that it works in
/// @param output file to which its standard output goes; the other is for its errors
/// Throws std::system_error.
pid_t start_detached(const std::vector<std::string>& words, const base::FileDescriptor& folder,
                     const std::filesystem::path& output, const std::filesystem::path& errors);

/// Output of a program until its end.
struct Outcome {
  int exit_code = -1; ///< negative when it was ended from outside
  bool timed_out = false;
  std::string output, errors;

  /// Puts the name that the user knows into the errors, where the program was given another.
  void rename(const std::string& given, const std::string& known);
};

/// Runs a program to its end with bounded time, memory and output, confined to the folder that it
/// works in.
/// @param memory address space [bytes]; 0 for no bound
Outcome run_to_end(const std::vector<std::string>& words, const base::FileDescriptor& folder,
                   std::chrono::seconds time, std::size_t memory);

} // namespace ionskin::apps::studio
