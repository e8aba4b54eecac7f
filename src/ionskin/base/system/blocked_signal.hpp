// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <csignal>

namespace ionskin::base {

/// The calling thread is not given a signal while this lives; one sent meanwhile comes afterwards,
/// or goes to a thread that takes it. Threads that are started meanwhile are never given it.
class BlockedSignal {
public:
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
