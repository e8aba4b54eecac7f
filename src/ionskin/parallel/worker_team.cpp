// SPDX-License-Identifier: Apache-2.0
#include "ionskin/parallel/worker_team.hpp"

#include "ionskin/base/system/blocked_signal.hpp"

#include <algorithm>

namespace ionskin::parallel {
namespace {

constexpr std::uint64_t closed = 0xffffffffU;
constexpr std::uint64_t next_loop = closed + 1;
/// Number of times that a worker checks the ticket for a new loop before it sleeps: about the
/// length of the serial work between loops.
constexpr int patience = 4000;
/// Blocks of a loop for each thread. More than one, so that a late thread leaves less to wait for.
constexpr std::size_t blocks_per_thread = 2;

/// Wait for the other threads, beyond twice the time of the calling thread's own work, above which
/// one of them is taken to have no processor and new trials begin.
constexpr std::chrono::microseconds stall_allowance{200};
/// Numbers of loops per trial and per rest: a trial covers some time steps; rests are long enough
/// to make trials cheap and short enough to make a wrong verdict cost little.
constexpr int loops_per_trial = 256, loops_of_rest = 2048;
/// Excess of a shared trial's time over that of the trial alone that is still allowed [%]. The two
/// trials run different loops; a thread without a processor makes the shared trial take about twice
/// as long.
constexpr int allowed_excess_percent = 40;

constexpr std::uint64_t from_the_end = 1U << 16;

std::size_t taken_from_the_start(std::uint64_t ticket) {
  return ticket & 0xffffU;
}
std::size_t taken_from_the_end(std::uint64_t ticket) {
  return (ticket >> 16) & 0xffffU;
}
std::size_t taken(std::uint64_t ticket) {
  return taken_from_the_start(ticket) + taken_from_the_end(ticket);
}

void relax() {
#if defined(__x86_64__)
  __builtin_ia32_pause();
#else
  std::this_thread::yield();
#endif
}

} // namespace

WorkerTeam::WorkerTeam(int threads) : ticket_(closed) {
  const base::BlockedSignal for_the_main_thread(SIGTERM);
  for (int i = 1; i < threads; ++i) {
    workers_.emplace_back([this, i] { work(static_cast<std::size_t>(i)); });
  }
}

WorkerTeam::~WorkerTeam() {
  stop_ = true;
  ticket_ += next_loop;
  ticket_.notify_all();
  for (std::thread& worker : workers_) {
    worker.join();
  }
}

std::size_t WorkerTeam::block_count(std::size_t count, std::size_t granularity) const {
  const std::size_t units = (count + granularity - 1) / granularity;
  return size() == 1 ? 1 : std::min(units, blocks_per_thread * size());
}

void WorkerTeam::Loop::run_block(std::size_t block, std::size_t worker) const {
  const std::size_t units = (count + granularity - 1) / granularity;
  const std::size_t begin = block * units / blocks * granularity;
  const std::size_t end = std::min(count, (block + 1) * units / blocks * granularity);
  call(body, begin, end, worker);
}

void WorkerTeam::run(const Loop& loop) {
  if (loop.count == 0) {
    return;
  }
  if (loop.blocks == 1 || next_loop_is_alone()) {
    loop.call(loop.body, 0, loop.count, 0);
    return;
  }
  // The ticket is closed, so that no worker can take a block of a loop that is still being set up.
  loop_.store(&loop, std::memory_order_relaxed);
  blocks_.store(loop.blocks, std::memory_order_relaxed);
  finished_.store(0, std::memory_order_relaxed);
  const std::uint64_t opened = (ticket_.load(std::memory_order_relaxed) & ~closed) + next_loop;
  const auto begin = Clock::now();
  ticket_.store(opened, std::memory_order_release);
  ticket_.notify_all();
  take_blocks(0);
  const auto own_end = Clock::now();
  // A yield may cost a whole time slice, so it comes only after `patience` checks.
  for (int looks = 0; finished_.load(std::memory_order_acquire) != loop.blocks; ++looks) {
    looks < patience ? relax() : std::this_thread::yield();
  }
  ticket_.store(opened | closed, std::memory_order_relaxed);
  look_at_clock(own_end - begin, Clock::now() - own_end);
}

void WorkerTeam::look_at_clock(Clock::duration worked, Clock::duration waited) {
  if (phase_ == Phase::rest && waited > 2 * worked + stall_allowance) {
    begin_phase(Phase::trial_alone);
  } else if (phase_ == Phase::trial_together && Clock::now() - phase_begin_ > time_allowed_) {
    faster_alone_ = true;
    begin_phase(Phase::rest);
  }
}

void WorkerTeam::begin_phase(Phase phase) {
  phase_ = phase;
  loops_left_ = phase == Phase::rest ? loops_of_rest : loops_per_trial;
  phase_begin_ = Clock::now();
}

bool WorkerTeam::next_loop_is_alone() {
  if (loops_left_ == 0) {
    switch (phase_) {
    case Phase::rest:
      begin_phase(Phase::trial_alone);
      break;
    case Phase::trial_alone:
      time_allowed_ = (Clock::now() - phase_begin_) * (100 + allowed_excess_percent) / 100;
      begin_phase(Phase::trial_together);
      break;
    case Phase::trial_together:
      faster_alone_ = false;
      begin_phase(Phase::rest);
      break;
    }
  }
  --loops_left_;
  return phase_ == Phase::trial_alone || (phase_ == Phase::rest && faster_alone_);
}

void WorkerTeam::take_blocks(std::size_t worker) {
  const bool caller = worker == 0;
  while (true) {
    std::uint64_t ticket = ticket_.load(std::memory_order_acquire);
    const std::size_t blocks = blocks_.load(std::memory_order_relaxed);
    if (taken(ticket) >= blocks) {
      return;
    }
    const Loop* loop = loop_.load(std::memory_order_relaxed);
    const std::size_t block =
        caller ? taken_from_the_start(ticket) : blocks - 1 - taken_from_the_end(ticket);
    // Succeeds only while the ticket, and with it the loop just read, is still the same.
    if (ticket_.compare_exchange_strong(ticket, ticket + (caller ? 1 : from_the_end),
                                        std::memory_order_acq_rel)) {
      loop->run_block(block, worker);
      finished_.fetch_add(1, std::memory_order_release);
    }
  }
}

void WorkerTeam::work(std::size_t worker) {
  while (!stop_) {
    const std::uint64_t seen = ticket_.load(std::memory_order_acquire);
    take_blocks(worker);
    int looks = 0;
    while (ticket_.load(std::memory_order_relaxed) / next_loop == seen / next_loop &&
           ++looks < patience) {
      relax();
    }
    if (looks == patience) {
      const std::uint64_t idle = ticket_.load(std::memory_order_acquire);
      if ((idle & closed) == closed && !stop_) {
        ticket_.wait(idle);
      }
    }
  }
}

} // namespace ionskin::parallel
