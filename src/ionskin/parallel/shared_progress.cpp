// SPDX-License-Identifier: Apache-2.0
#include "ionskin/parallel/shared_progress.hpp"

#include <algorithm>

namespace ionskin::parallel {

void SharedProgress::begin_pass(std::size_t expected, double share) {
  const std::lock_guard lock(mutex_);
  expected_ = expected;
  known_ = finished_ = 0;
  end_ = reported_ + share * (1 - reported_);
}

void SharedProgress::add_units(std::size_t units) {
  const std::lock_guard lock(mutex_);
  known_ += units;
}

void SharedProgress::finish_unit() {
  const std::lock_guard lock(mutex_);
  const std::size_t all = std::max({known_, expected_, finished_ + 1});
  reported_ += (end_ - reported_) / static_cast<double>(all - finished_);
  ++finished_;
  callback_(activity_, reported_);
}

void SharedProgress::finish() {
  const std::lock_guard lock(mutex_);
  reported_ = 1;
  callback_(activity_, reported_);
}

} // namespace ionskin::parallel
