// SPDX-License-Identifier: Apache-2.0
#include "ionskin/parallel/worker_team.hpp"

#include "ionskin/base/system/blocked_signal.hpp"

namespace ionskin::parallel {
namespace {

/// Number of times that a thread checks for what it waits for before it sleeps or yields: about the
/// length of the serial work between loops.
constexpr int patience = 4000;
/// Blocks of a loop for each thread. More than one, so that a late thread leaves less to wait for.
constexpr std::size_t blocks_per_thread = 2;

/// Number of shared loops in one judgement, and the wait beyond which one loop is judged by itself:
/// then another thread has no processor.
constexpr int loops_of_judgement = 64;
constexpr std::chrono::microseconds stall{500};
/// Numbers of loops that the calling thread runs alone after a judgement: doubled where sharing
/// does not pay again, and halved where it does.
constexpr int fewest_alone = 256, most_alone = 4096;

void relax() {
#if defined(__x86_64__)
  __builtin_ia32_pause();
#else
  std::this_thread::yield();
#endif
}

} // namespace

WorkerTeam::WorkerTeam(int threads)
    : blocks_(blocks_per_thread * static_cast<std::size_t>(threads)), next_block_(blocks_),
      next_alone_(fewest_alone) {
  const base::BlockedSignal for_the_main_thread(SIGTERM);
  for (int i = 1; i < threads; ++i) {
    workers_.emplace_back([this, i] { work(static_cast<std::size_t>(i)); });
  }
}

WorkerTeam::~WorkerTeam() {
  stop_ = true;
  ++next_block_;
  next_block_.notify_all();
  for (std::thread& worker : workers_) {
    worker.join();
  }
}

void WorkerTeam::share(const Loop& loop) {
  const auto begin = Clock::now();
  loop_ = &loop;
  finished_.store(0, std::memory_order_relaxed);
  next_block_.store(0, std::memory_order_release);
  next_block_.notify_all();
  const std::size_t own = take_blocks(0);
  const auto own_end = Clock::now();
  // A yield may cost a whole time slice, so it comes only after `patience` checks.
  for (int looks = 0; finished_.load(std::memory_order_acquire) != blocks_; ++looks) {
    looks < patience ? relax() : std::this_thread::yield();
  }
  if (own > 0) {
    judge(Clock::now() - begin, (own_end - begin) * blocks_ / own);
  }
}

void WorkerTeam::judge(Clock::duration shared, Clock::duration alone) {
  shared_ += shared;
  alone_ += alone;
  if (++judged_loops_ < loops_of_judgement && shared < alone + stall) {
    return;
  }
  if (shared_ > alone_) {
    loops_alone_ = next_alone_;
    next_alone_ = std::min(2 * next_alone_, most_alone);
  } else {
    next_alone_ = std::max(next_alone_ / 2, fewest_alone);
  }
  judged_loops_ = 0;
  shared_ = alone_ = {};
}

bool WorkerTeam::goes_on_alone() {
  return loops_alone_ > 0 && loops_alone_-- > 0;
}

std::size_t WorkerTeam::take_blocks(std::size_t worker) {
  std::size_t taken = 0;
  while (next_block_.load(std::memory_order_relaxed) < blocks_) {
    const std::size_t block = next_block_.fetch_add(1, std::memory_order_acquire);
    if (block < blocks_) {
      loop_->run_block(loop_->object, block, blocks_, worker);
      finished_.fetch_add(1, std::memory_order_release);
      ++taken;
    }
  }
  return taken;
}

void WorkerTeam::work(std::size_t worker) {
  while (!stop_) {
    take_blocks(worker);
    int looks = 0;
    while (next_block_.load(std::memory_order_relaxed) >= blocks_ && ++looks < patience) {
      relax();
    }
    if (looks == patience) {
      const std::size_t idle = next_block_;
      if (idle >= blocks_ && !stop_) {
        next_block_.wait(idle);
      }
    }
  }
}

} // namespace ionskin::parallel
