// SPDX-License-Identifier: Apache-2.0
#include "ionskin/results/atomic_file.hpp"

#include "ionskin/base/error.hpp"
#include "scratch_folder.hpp"

#include <gtest/gtest.h>

namespace ionskin::results {
namespace {

TEST(AtomicFile, AppearsOnlyWhenCommitted) {
  const ScratchFolder folder;
  AtomicFile file(folder / "a.txt");
  file.stream() << "text";
  EXPECT_FALSE(std::filesystem::exists(folder / "a.txt"));
  file.commit();
  EXPECT_EQ(read_all(folder / "a.txt"), "text");
  EXPECT_FALSE(std::filesystem::exists(folder / "a.txt.tmp"));
}

TEST(AtomicFile, KeepsTheOldContentAndNoRestWhenNotCommitted) {
  const ScratchFolder folder;
  write_text_file(folder / "a.txt", "old");
  {
    AtomicFile file(folder / "a.txt");
    file.stream() << "half";
  }
  EXPECT_EQ(read_all(folder / "a.txt"), "old");
  EXPECT_FALSE(std::filesystem::exists(folder / "a.txt.tmp"));
}

TEST(AtomicFile, NamesTheFileThatCannotBeWritten) {
  const ScratchFolder folder;
  const std::string message =
      message_of<UserError>([&] { write_text_file(folder / "missing/a.txt", "text"); });
  EXPECT_NE(message.find("missing/a.txt"), std::string::npos) << message;
  EXPECT_NE(message.find("No such file"), std::string::npos) << message;
}

TEST(AtomicFile, ReportsAFullDisc) {
  if (!std::filesystem::exists("/dev/full")) {
    GTEST_SKIP() << "no /dev/full here";
  }
  const ScratchFolder folder;
  std::filesystem::create_symlink("/dev/full", folder / "a.txt.tmp");
  const std::string message =
      message_of<UserError>([&] { write_text_file(folder / "a.txt", "text"); });
  EXPECT_NE(message.find("No space left"), std::string::npos) << message;
  EXPECT_FALSE(std::filesystem::exists(folder / "a.txt"));
}

TEST(AtomicFile, DoesNotReplaceAFolder) {
  const ScratchFolder folder;
  std::filesystem::create_directory(folder / "a.txt");
  EXPECT_THROW(write_text_file(folder / "a.txt", "text"), UserError);
}

} // namespace
} // namespace ionskin::results
