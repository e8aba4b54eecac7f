// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <csignal>

namespace ionskin::base {

/// Guard that blocks one signal in the calling thread while it lives. A signal sent to the process
/// in the meantime goes to another thread that accepts it, or is delivered afterwards. Threads
/// started in the meantime inherit the block for good.
class BlockedSignal {
public:
  /// @param signal number of the signal, such as SIGTERM
  explicit BlockedSignal(int signal) {
    sigset_t blocked;
    sigemptyset(&blocked);
    sigaddset(&blocked, signal);
    pthread_sigmask(SIG_BLOCK, &blocked, &former_);
  }
  BlockedSignal(const BlockedSignal&) = delete;
  BlockedSignal& operator=(const BlockedSignal&) = delete;
  ~BlockedSignal() { pthread_sigmask(SIG_SETMASK, &former_, nullptr); }

private:
  sigset_t former_;
};

} // namespace ionskin::base
