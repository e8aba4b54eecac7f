// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <sys/types.h>
#include <vector>

namespace ionskin::base {

/// Argument list for exec(3): pointers into `words`, ended by a null pointer. They are valid as
/// long as `words` is not changed.
/// @param words program and its arguments
std::vector<char*> argument_pointers(std::vector<std::string>& words);

/// File descriptors for the standard output and error output of a new process; -1: inherit from
/// this process.
struct ProcessOutputs {
  int output = -1, errors = -1;
};

/// Starts a program in a new process (posix_spawn), also from a process with threads and much
/// memory.
/// @param words path of the program, then its arguments
/// @return id of the process; -1, with errno set, when it cannot be started
pid_t start_program(std::vector<std::string> words, const ProcessOutputs& outputs = {});

/// Waits until a child of this process has ended.
/// @return exit status of the child, or minus the number of the signal that ended it; 127 if the
/// process is not a child, or has been waited for already
int wait_for_end(pid_t process);

} // namespace ionskin::base
