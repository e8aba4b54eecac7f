// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/position/position_memory.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace ionskin::mechanics {

PositionMemory& PositionMemory::of_process() {
  static PositionMemory memory;
  return memory;
}

void PositionMemory::set_bound(std::size_t most_bytes) {
  const std::lock_guard lock(mutex_);
  most_bytes_ = most_bytes;
  make_room();
}

std::shared_ptr<const StoredPosition> PositionMemory::find(const base::Digest& key) {
  const std::lock_guard lock(mutex_);
  const auto found = std::ranges::find(entries_, key, &Entry::key);
  if (found == entries_.end()) {
    return nullptr;
  }
  entries_.splice(entries_.begin(), entries_, found);
  return entries_.front().position;
}

void PositionMemory::keep(const base::Digest& key, std::shared_ptr<const StoredPosition> position) {
  const std::lock_guard lock(mutex_);
  if (most_bytes_ == 0) {
    return;
  }
  std::erase_if(entries_, [&](const Entry& entry) { return entry.key == key; });
  entries_.push_front({key, std::move(position)});
  make_room();
}

void PositionMemory::make_room() {
  std::size_t total = 0;
  const auto first_beyond = std::ranges::find_if(entries_, [&](const Entry& entry) {
    total += bytes_of(*entry.position);
    return total > most_bytes_;
  });
  entries_.erase(first_beyond, entries_.end());
}

std::size_t bytes_of(const StoredPosition& position) {
  std::size_t bytes = position.compliance.values.size() * sizeof(double);
  for (const auto& response : position.response) {
    if (response) {
      bytes +=
          (response->core.values.size() + response->membrane.values.size()) * sizeof(std::int32_t) +
          response->base_reaction.values.size() * sizeof(double);
    }
  }
  return bytes;
}

} // namespace ionskin::mechanics
