// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/worker_team.hpp"

#include <algorithm>

namespace ionskin::electrochemistry {
namespace {

constexpr std::uint64_t closed = 0xffffffffU;
constexpr std::uint64_t next_loop = closed + 1;
/// Looks at the ticket before a worker goes to sleep, about the length of the serial work between
/// loops.
constexpr int patience = 4000;
/// More blocks than threads, so that a late thread leaves less to wait for.
constexpr std::size_t blocks_per_thread = 2;

std::uint64_t block_of(std::uint64_t ticket) {
  return ticket & closed;
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
  if (loop.blocks == 1) {
    loop.run_block(0, 0);
    return;
  }
  // The ticket is closed, so no worker reads what is being changed here and then takes a block of
  // it.
  loop_.store(&loop, std::memory_order_relaxed);
  blocks_.store(loop.blocks, std::memory_order_relaxed);
  finished_.store(0, std::memory_order_relaxed);
  const std::uint64_t opened = (ticket_.load(std::memory_order_relaxed) & ~closed) + next_loop;
  ticket_.store(opened, std::memory_order_release);
  ticket_.notify_all();
  take_blocks(0);
  // A yield may cost a whole time slice, so it comes late.
  for (int looks = 0; finished_.load(std::memory_order_acquire) != loop.blocks; ++looks) {
    looks < patience ? relax() : std::this_thread::yield();
  }
  ticket_.store(opened | closed, std::memory_order_relaxed);
}

void WorkerTeam::take_blocks(std::size_t worker) {
  while (true) {
    std::uint64_t ticket = ticket_.load(std::memory_order_acquire);
    if (block_of(ticket) >= blocks_.load(std::memory_order_relaxed)) {
      return;
    }
    const Loop* loop = loop_.load(std::memory_order_relaxed);
    // Succeeds only while the ticket, and with it the loop just read, is still the same.
    if (ticket_.compare_exchange_strong(ticket, ticket + 1, std::memory_order_acq_rel)) {
      loop->run_block(block_of(ticket), worker);
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
      if (block_of(idle) == closed && !stop_) {
        ticket_.wait(idle);
      }
    }
  }
}

} // namespace ionskin::electrochemistry
