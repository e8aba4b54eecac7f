// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/base/system/file_descriptor.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <sys/types.h>
#include <vector>

namespace ionskin::base {

/// A program that this one carries in its own memory, run as a process apart: whatever happens
/// there, this process goes on. Standard input of the child is a socket to this object, descriptor
/// 3 the file that it is given; it has no other files, no output and, but for the search path of
/// libraries, no environment. It is ended with this object. Works from processes with threads.
class ChildProgram {
public:
  /// @param image the executable's bytes, which must outlive the process
  /// @param arguments behind the program's name
  /// @param file handed to the child
  /// Throws UserError when the system refuses another process.
  ChildProgram(std::string_view image, const std::string& name,
               const std::vector<std::string>& arguments, int file);
  ~ChildProgram();
  ChildProgram(const ChildProgram&) = delete;
  ChildProgram& operator=(const ChildProgram&) = delete;

  enum class Transfer { done, ended, late };
  /// `ended` when the child has closed its end.
  Transfer send(const void* bytes, std::size_t count);
  /// Receives so many bytes from the child; `ended` when it has closed its end, `late` when not all
  /// of them have come in time.
  /// @param seconds in which all of it must have come
  /// Throws Interrupted when the user asks to stop meanwhile.
  Transfer receive(void* bytes, std::size_t count, double seconds);
  /// Ends the child, unless it has ended itself, and returns the signal that it ended by; 0 when it
  /// ended by none or when that is not known.
  int end();

private:
  FileDescriptor socket_;
  pid_t process_ = -1;
};

} // namespace ionskin::base
