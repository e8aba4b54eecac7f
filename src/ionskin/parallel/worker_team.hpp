// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <thread>
#include <vector>

namespace ionskin::parallel {

/// Threads that wait for work and share many short loops of a solver, some ten microseconds each.
/// They are started once, whereas `parallel::run_tasks` starts threads in each call; and each block
/// of a loop goes to the next free thread, whereas OpenMP waits for every thread at the end of a
/// loop. On a busy machine, where threads wait for a processor, the calling thread is faster alone:
/// the team compares both from the time of its own blocks, and leaves loops to the calling thread
/// for a while where sharing does not pay.
class WorkerTeam {
public:
  /// Starts `threads` - 1 worker threads.
  /// @param threads number that share the loops, at least 1, the calling thread included
  explicit WorkerTeam(int threads);
  ~WorkerTeam();
  WorkerTeam(const WorkerTeam&) = delete;
  WorkerTeam& operator=(const WorkerTeam&) = delete;

  /// Number of threads, the calling one included.
  std::size_t size() const { return workers_.size() + 1; }

  /// Calls `body(begin, end, worker)` on contiguous blocks that cover [0, count) and waits until
  /// all are done. Block borders are multiples of `granularity`; `worker`, below size(), is the
  /// number of the thread, 0 for the calling one. The body must give every index the same result
  /// whichever block and thread it falls to, so that results do not depend on the number of
  /// threads, and must not throw.
  template <class Body>
  void for_blocks(std::size_t count, std::size_t granularity, const Body& body) {
    const std::size_t units = (count + granularity - 1) / granularity;
    const auto run_block = [&](std::size_t block, std::size_t blocks, std::size_t worker) {
      const std::size_t begin = block * units / blocks * granularity;
      const std::size_t end = std::min(count, (block + 1) * units / blocks * granularity);
      if (begin < end) {
        body(begin, end, worker);
      }
    };
    if (units < 2 || size() == 1 || goes_on_alone()) {
      run_block(0, 1, 0);
      return;
    }
    share({&run_block,
           [](const void* object, std::size_t block, std::size_t blocks, std::size_t worker) {
             (*static_cast<const decltype(run_block)*>(object))(block, blocks, worker);
           }});
  }

private:
  struct Loop {
    const void* object;
    void (*run_block)(const void* object, std::size_t block, std::size_t blocks,
                      std::size_t worker);
  };
  using Clock = std::chrono::steady_clock;

  /// Runs a loop on all threads, and waits until it is done.
  void share(const Loop& loop);
  /// Runs blocks of the current loop until all are taken. @returns how many it ran
  std::size_t take_blocks(std::size_t worker);
  void work(std::size_t worker);
  /// Counts a loop that would be shared. @returns true if the calling thread runs it alone
  bool goes_on_alone();
  /// Judges whether sharing pays, from the loops since the last judgement.
  /// @param shared duration of one more shared loop
  /// @param alone duration that the calling thread would take for it alone
  void judge(Clock::duration shared, Clock::duration alone);

  const std::size_t blocks_; ///< number of blocks of every shared loop
  const Loop* loop_ = nullptr;
  /// Next block of the current loop; from `blocks_` on where all are taken, as between loops.
  /// Setting it to 0 hands `loop_` to the workers. A thread that has taken a block may use `loop_`,
  /// as the loop ends only after this block.
  std::atomic<std::size_t> next_block_;
  std::atomic<std::size_t> finished_{0}; ///< number of finished blocks of the current loop
  std::atomic<bool> stop_{false};

  int judged_loops_ = 0;               ///< number of shared loops since the last judgement
  Clock::duration shared_{}, alone_{}; ///< sums over these loops
  int loops_alone_ = 0;                ///< number of loops left to the calling thread
  int next_alone_ = 0;                 ///< number that it takes when sharing does not pay again
  std::vector<std::thread> workers_;
};

} // namespace ionskin::parallel
