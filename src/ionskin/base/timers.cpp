// SPDX-License-Identifier: Apache-2.0
#include "ionskin/base/timers.hpp"

#include <chrono>
#include <sys/resource.h>
#include <utility>

namespace ionskin::base {

Timers::Scope::Scope(Timers& timers, std::string stage)
    : timers_(timers), stage_(std::move(stage)), start_(wall_time()) {}

Timers::Scope::~Scope() {
  timers_.add(stage_, wall_time() - start_);
}

void Timers::add(const std::string& stage, double seconds) {
  const std::lock_guard lock(mutex_);
  seconds_[stage] += seconds;
}

std::map<std::string, double> Timers::seconds() const {
  const std::lock_guard lock(mutex_);
  return seconds_;
}

double wall_time() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double processor_time() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

double peak_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) * 1024.0; // Linux reports KiB
}

} // namespace ionskin::base
