// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <mutex>
#include <string>

namespace ionskin::base {

/// Wall times of named stages, summed over several measurements; safe to use from several threads.
class Timers {
public:
  /// Timer that adds the wall time from its construction to its destruction to a stage. The
  /// `Timers` must outlive it.
  class Scope {
  public:
    Scope(Timers& timers, std::string stage);
    ~Scope();
    Scope(const Scope&) = delete;
    Scope& operator=(const Scope&) = delete;

  private:
    Timers& timers_;
    std::string stage_;
    double start_;
  };

  /// Adds a wall time to a stage; a new stage starts at 0.
  /// @param seconds wall time [s]
  void add(const std::string& stage, double seconds);
  /// Wall times by stage [s].
  std::map<std::string, double> seconds() const;

private:
  mutable std::mutex mutex_;
  std::map<std::string, double> seconds_;
};

/// Wall clock time since an arbitrary start [s]; it never goes back.
double wall_time();
/// Processor time of this process so far, all threads [s].
double processor_time();
/// Largest resident memory of this process so far [bytes].
double peak_memory();

} // namespace ionskin::base
