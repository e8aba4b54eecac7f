// SPDX-License-Identifier: Apache-2.0
#include "ionskin/base/files/atomic_file.hpp"

#include "ionskin/base/error.hpp"
#include "scratch_folder.hpp"

#include <gtest/gtest.h>

#include <csignal>
#include <iterator>
#include <sys/resource.h>

namespace ionskin::base {
namespace {

using results::message_of;
using results::read_all;
using results::ScratchFolder;

std::ptrdiff_t files_in(const std::filesystem::path& folder) {
  return std::distance(std::filesystem::directory_iterator(folder), {});
}

/// Lets no file grow beyond some bytes while it lives.
class FileSizeLimit {
public:
  explicit FileSizeLimit(rlim_t bytes) : former_(std::signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &before_);
    rlimit small = before_;
    small.rlim_cur = bytes;
    setrlimit(RLIMIT_FSIZE, &small);
  }
  ~FileSizeLimit() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, former_);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;

private:
  void (*former_)(int);
  rlimit before_{};
};

TEST(AtomicFile, AppearsOnlyWhenCommitted) {
  const ScratchFolder folder;
  AtomicFile file(folder / "a.txt");
  file.stream() << "text";
  EXPECT_FALSE(std::filesystem::exists(folder / "a.txt"));
  file.commit();
  EXPECT_EQ(read_all(folder / "a.txt"), "text");
  EXPECT_EQ(files_in(folder.path()), 1);
}

TEST(AtomicFile, KeepsTheOldContentAndNoRestWhenNotCommitted) {
  const ScratchFolder folder;
  write_text_file(folder / "a.txt", "old");
  {
    AtomicFile file(folder / "a.txt");
    file.stream() << "half";
  }
  EXPECT_EQ(read_all(folder / "a.txt"), "old");
  EXPECT_EQ(files_in(folder.path()), 1);
}

TEST(AtomicFile, NamesTheFileThatCannotBeWritten) {
  const ScratchFolder folder;
  const std::string message =
      message_of<UserError>([&] { write_text_file(folder / "missing/a.txt", "text"); });
  EXPECT_NE(message.find("missing/a.txt"), std::string::npos) << message;
  EXPECT_NE(message.find("No such file"), std::string::npos) << message;
}

TEST(AtomicFile, NamesTheReasonAndNeverFailsItsStream) {
  const ScratchFolder folder;
  const FileSizeLimit limit(1000);
  AtomicFile file(folder / "a.txt");
  file.stream() << std::string(200'000, 'x') << std::flush << "more";
  EXPECT_TRUE(file.stream().good()) << "libraries throw at a stream that fails";
  const std::string message = message_of<UserError>([&] { file.commit(); });
  EXPECT_NE(message.find("File too large"), std::string::npos) << message;
  EXPECT_FALSE(std::filesystem::exists(folder / "a.txt"));
}

TEST(AtomicFile, ReplacesALinkAndLeavesItsTarget) {
  const ScratchFolder folder;
  results::write_all(folder / "thesis.txt", "mine");
  std::filesystem::create_symlink(folder / "thesis.txt", folder / "a.txt");
  write_text_file(folder / "a.txt", "text");
  EXPECT_EQ(read_all(folder / "thesis.txt"), "mine");
  EXPECT_EQ(read_all(folder / "a.txt"), "text");
}

TEST(PendingFiles, OfKilledWritersAreRemovedAndNothingElse) {
  const ScratchFolder folder;
  results::write_all(folder / "a.txt.77-0.ionskin-pending", "half");
  results::write_all(folder / "b.tmp", "mine");
  results::write_all(folder / "mine.txt", "mine");
  std::filesystem::create_symlink(folder / "mine.txt", folder / "link.ionskin-pending");
  remove_pending_files(folder.path());
  EXPECT_EQ(files_in(folder.path()), 3);
}

TEST(AtomicFile, DoesNotReplaceAFolder) {
  const ScratchFolder folder;
  std::filesystem::create_directory(folder / "a.txt");
  EXPECT_THROW(write_text_file(folder / "a.txt", "text"), UserError);
}

} // namespace
} // namespace ionskin::base
