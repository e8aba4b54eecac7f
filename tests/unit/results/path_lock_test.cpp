// SPDX-License-Identifier: Apache-2.0
#include "ionskin/results/path_lock.hpp"

#include "scratch_folder.hpp"

#include <gtest/gtest.h>

#include <sys/wait.h>
#include <unistd.h>

namespace ionskin::results {
namespace {

TEST(PathLock, KeepsOthersAwayWhileItLives) {
  const ScratchFolder scratch;
  {
    const auto lock = lock_path(scratch / ".", LockKind::exclusive);
    ASSERT_TRUE(lock);
    EXPECT_FALSE(lock_path(scratch / ".", LockKind::shared));
  }
  const auto shared = lock_path(scratch / ".", LockKind::shared);
  EXPECT_TRUE(lock_path(scratch / ".", LockKind::shared));
  EXPECT_FALSE(lock_path(scratch / ".", LockKind::exclusive));
}

TEST(PathLock, EndsThoughAChildStillSharesTheFile) {
  const ScratchFolder scratch;
  auto lock = lock_path(scratch / ".", LockKind::exclusive);
  ASSERT_TRUE(lock);
  int ends[2];
  ASSERT_EQ(::pipe(ends), 0);
  const pid_t child = ::fork();
  if (child == 0) { // holds what is open until the parent closes the pipe
    ::close(ends[1]);
    char none;
    ::_exit(::read(ends[0], &none, 1) == 0 ? 0 : 1);
  }
  ASSERT_GT(child, 0);
  lock.reset();
  EXPECT_TRUE(lock_path(scratch / ".", LockKind::exclusive));
  ::close(ends[0]);
  ::close(ends[1]);
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_EQ(status, 0);
}

} // namespace
} // namespace ionskin::results
