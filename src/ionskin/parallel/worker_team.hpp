// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <thread>
#include <vector>

namespace ionskin::parallel {

/// A few threads that share many short loops. parallel::run_tasks starts threads for each call, and
/// OpenMP waits for every thread at the end of each loop; here blocks go to whoever is there. On a
/// busy machine, where threads wait for a processor, and with loops too short to share, the calling
/// thread is faster alone: from time to time some loops are done either way, and where sharing
/// takes much longer, the calling thread goes on alone for a while.
class WorkerTeam {
public:
  /// @param threads at least 1, the calling one included
  explicit WorkerTeam(int threads);
  ~WorkerTeam();
  WorkerTeam(const WorkerTeam&) = delete;
  WorkerTeam& operator=(const WorkerTeam&) = delete;

  std::size_t size() const { return workers_.size() + 1; }

  /// Calls `body(begin, end, worker)` on contiguous blocks that cover [0, count) and waits for
  /// them. Block borders are multiples of `granularity`; `worker` is below size(). The body must
  /// give every index the same result whatever block and thread it falls to, so that results do not
  /// depend on the number of threads; it must not throw.
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
  /// Takes blocks of the current loop until none is left.
  void take_blocks(std::size_t worker);
  void work(std::size_t worker);

  using Clock = std::chrono::steady_clock;
  /// Mode of the calling thread for a number of loops. Trials are timed; the rest is together
  /// unless that took much longer.
  enum class Phase { trial_alone, trial_together, rest };

  /// Counts a loop. @returns whether the calling thread does it alone
  bool next_loop_is_alone();
  void begin_phase(Phase phase);
  /// Decides after a loop together: begins new trials after a stall, ends one that is lost.
  void look_at_clock(Clock::duration worked, Clock::duration waited);

  /// Number of the loop in the upper half; in the lower one the blocks that the caller has taken
  /// from the start and the others from the end, so that data stay with the same thread; `closed`
  /// between loops.
  std::atomic<std::uint64_t> ticket_;
  std::atomic<const Loop*> loop_{nullptr};
  std::atomic<std::size_t> blocks_{0}, finished_{0};
  std::atomic<bool> stop_{false};
  Phase phase_ = Phase::rest;
  int loops_left_ = 0; ///< of the phase
  bool faster_alone_ = false;
  Clock::time_point phase_begin_;
  Clock::duration time_allowed_{}; ///< for the trial together, from the last one alone
  std::vector<std::thread> workers_;
};

} // namespace ionskin::parallel
