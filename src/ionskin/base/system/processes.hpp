// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <sys/types.h>
#include <vector>

namespace ionskin::base {

/// Program and arguments as exec(3) takes them, ended by a null pointer; they point into `words`.
std::vector<char*> argument_pointers(std::vector<std::string>& words);

/// Descriptors that a new process writes to; -1: those of this process.
struct ProcessOutputs {
  int output = -1, errors = -1;
};

/// Starts a program, also from a process with threads and much memory.
/// @param words path of the program and its arguments
/// Returns the id of the process; -1, with errno set, where the system refuses it.
pid_t start_program(std::vector<std::string> words, const ProcessOutputs& outputs = {});

/// Waits until a child of this process has ended. Returns its exit status, or minus the number of
/// the signal that it ended by.
int wait_for_end(pid_t process);

} // namespace ionskin::base
