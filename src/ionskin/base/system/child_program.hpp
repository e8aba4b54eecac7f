// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/base/system/file_descriptor.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <sys/types.h>
#include <vector>

namespace ionskin::base {

/// Separate process that runs a program embedded in this one, so that a crash there does not affect
/// this process. Standard input of the child is a socket connected to this object; its descriptor 3
/// is a given file. The child has no other input, no output, and no environment except the search
/// path of libraries. The destructor ends the child. Works in processes with several threads.
class ChildProgram {
public:
  /// Starts the child.
  /// @param image bytes of the executable, which must stay valid until this process ends
  /// @param name of the program, for the system and for messages
  /// @param arguments of the program, without its name
  /// @param file descriptor that the child receives as descriptor 3
  /// Throws UserError when the system cannot start another process.
  ChildProgram(std::string_view image, const std::string& name,
               const std::vector<std::string>& arguments, int file);
  ~ChildProgram();
  ChildProgram(const ChildProgram&) = delete;
  ChildProgram& operator=(const ChildProgram&) = delete;

  /// Outcome of a transfer: complete, child has closed its end, or time limit reached.
  enum class Transfer { done, ended, late };
  /// Sends bytes to the child, which reads them from its standard input; waits until all are sent.
  /// Returns `ended` when the child has closed its end, else `done`.
  /// @param count number of bytes
  Transfer send(const void* bytes, std::size_t count);
  /// Receives bytes from the child. Returns `done` when all have arrived, `ended` when the child
  /// has closed its end before, `late` when the time limit is over.
  /// @param bytes buffer for `count` bytes
  /// @param seconds time limit for all of them [s]
  /// Throws Interrupted when the user asks to stop in the meantime.
  Transfer receive(void* bytes, std::size_t count, double seconds);
  /// Ends the child if it still runs. Returns the number of the signal that had ended it before; 0
  /// when no signal had, or when it is not known.
  int end();

private:
  FileDescriptor socket_;
  pid_t process_ = -1;
};

} // namespace ionskin::base
