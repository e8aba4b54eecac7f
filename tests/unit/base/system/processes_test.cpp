// SPDX-License-Identifier: Apache-2.0
#include "ionskin/base/system/file_descriptor.hpp"
#include "ionskin/base/system/processes.hpp"

#include <gtest/gtest.h>

#include <cerrno>
#include <csignal>
#include <fcntl.h>
#include <string>
#include <unistd.h>

namespace ionskin::base {
namespace {

std::string read_all(int descriptor) {
  std::string text;
  char character = 0;
  while (read(descriptor, &character, 1) == 1) {
    text += character;
  }
  return text;
}

TEST(Processes, EndTellsStatusOrSignal) {
  EXPECT_EQ(wait_for_end(start_program({"/bin/sh", "-c", "exit 7"})), 7);
  EXPECT_EQ(wait_for_end(start_program({"/bin/sh", "-c", "kill -TERM $$"})), -SIGTERM);
  const pid_t ended = start_program({"/bin/sh", "-c", "exit 0"});
  EXPECT_EQ(wait_for_end(ended), 0);
  EXPECT_EQ(wait_for_end(ended), 127); // no success that nobody has seen
}

TEST(Processes, OutputAndErrorsGoWhereTheyAreSent) {
  int output[2], errors[2];
  ASSERT_EQ(pipe2(output, O_CLOEXEC), 0);
  ASSERT_EQ(pipe2(errors, O_CLOEXEC), 0);
  const FileDescriptor first(output[0]), second(errors[0]);
  FileDescriptor output_end(output[1]), errors_end(errors[1]);
  const pid_t child =
      start_program({"/bin/sh", "-c", "printf '%s' \"$1\"; printf two >&2", "sh", "one word"},
                    {output_end, errors_end});
  output_end = FileDescriptor();
  errors_end = FileDescriptor();
  EXPECT_EQ(read_all(first), "one word");
  EXPECT_EQ(read_all(second), "two");
  EXPECT_EQ(wait_for_end(child), 0);
}

TEST(Processes, ProgramThatIsNotThereIsNotStarted) {
  EXPECT_EQ(start_program({"/nowhere/program"}), -1);
  EXPECT_EQ(errno, ENOENT);
}

} // namespace
} // namespace ionskin::base
