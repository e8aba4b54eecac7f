// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <mutex>
#include <string>

namespace ionskin::base {

/// Wall time per named stage; safe to use from several threads.
class Timers {
public:
  /// Adds the time from construction to destruction to a stage.
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

  /// Adds a duration to a stage, which is made if it is new.
  /// @param seconds wall time to add to a stage
  void add(const std::string& stage, double seconds);
  /// Wall time per stage [s].
  std::map<std::string, double> seconds() const;

private:
  mutable std::mutex mutex_;
  std::map<std::string, double> seconds_;
};

/// Wall clock since an arbitrary start [s].
double wall_time();
/// Processor time of this process so far, all threads [s].
double processor_time();
/// Largest resident memory of this process so far [bytes].
double peak_memory();

} // namespace ionskin::base
