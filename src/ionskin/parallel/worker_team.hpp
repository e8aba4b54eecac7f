// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <thread>
#include <vector>

namespace ionskin::parallel {

/// Threads that wait for work and share many short loops of a solver, some ten microseconds each.
/// They are started once, whereas `parallel::run_tasks` starts threads in each call; and each block
/// of a loop goes to the next free thread, whereas OpenMP waits for every thread at the end of a
/// loop. On a busy machine, where threads wait for a processor, the calling thread is faster alone.
/// The team therefore times some loops both ways now and then, and leaves loops to the calling
/// thread for a while where sharing takes much longer.
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
    const Loop loop{&body,
                    [](const void* object, std::size_t begin, std::size_t end, std::size_t worker) {
                      (*static_cast<const Body*>(object))(begin, end, worker);
                    },
                    count, granularity, block_count(count, granularity)};
    run(loop);
  }

private:
  struct Loop {
    const void* body;
    void (*call)(const void* body, std::size_t begin, std::size_t end, std::size_t worker);
    std::size_t count, granularity, blocks;

    void run_block(std::size_t block, std::size_t worker) const;
  };

  std::size_t block_count(std::size_t count, std::size_t granularity) const;
  void run(const Loop& loop);
  /// Runs blocks of the current loop until none is left.
  void take_blocks(std::size_t worker);
  void work(std::size_t worker);

  using Clock = std::chrono::steady_clock;
  /// Mode in which loops are run for a number of loops: timed trials by the calling thread alone,
  /// then by all threads together; then a rest in the faster mode.
  enum class Phase { trial_alone, trial_together, rest };

  /// Counts one loop and moves on to the next phase where the present one is over. @returns true if
  /// the calling thread runs the loop alone
  bool next_loop_is_alone();
  /// Begins a phase with its full number of loops and starts its clock.
  void begin_phase(Phase phase);
  /// Changes the phase after a shared loop where needed: a long wait for other threads begins new
  /// trials; a shared trial that takes too long ends, and the calling thread goes on alone.
  /// @param worked time that the calling thread spent on its blocks
  /// @param waited time that it then waited for other threads
  void look_at_clock(Clock::duration worked, Clock::duration waited);

  /// State of the current loop in one atomic word. Upper 32 bits: number of the loop. Lower 32
  /// bits: blocks that the calling thread has taken from the start (low half) and that workers have
  /// taken from the end (high half), so that the same data stay with the same thread; `closed`
  /// between loops.
  std::atomic<std::uint64_t> ticket_;
  std::atomic<const Loop*> loop_{nullptr};
  std::atomic<std::size_t> blocks_{0}, finished_{0};
  std::atomic<bool> stop_{false};
  Phase phase_ = Phase::rest;
  int loops_left_ = 0; ///< remaining loops of the present phase
  /// Result of the last trials: true if the calling thread is faster without the workers.
  bool faster_alone_ = false;
  Clock::time_point phase_begin_;
  /// Longest time of the shared trial, from the time of the trial alone.
  Clock::duration time_allowed_{};
  std::vector<std::thread> workers_;
};

} // namespace ionskin::parallel
