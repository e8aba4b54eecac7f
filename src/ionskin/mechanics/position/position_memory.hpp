// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/base/digest.hpp"
#include "ionskin/mechanics/position/unit_response.hpp"

#include <cstddef>
#include <list>
#include <memory>
#include <mutex>

namespace ionskin::mechanics {

/// Condensed positions that a process which runs case after case keeps, in front of the cache on
/// disk: reading one takes longer than its products. Of a bound of 0, as at the start, nothing is
/// kept. Beyond the bound the least recently used go. Safe to use from several threads.
class PositionMemory {
public:
  /// Of this process.
  static PositionMemory& of_process();

  void set_bound(std::size_t most_bytes);
  /// Null where it is not kept.
  std::shared_ptr<const StoredPosition> find(const base::Digest& key);
  void keep(const base::Digest& key, std::shared_ptr<const StoredPosition> position);

private:
  struct Entry {
    base::Digest key;
    std::shared_ptr<const StoredPosition> position;
  };
  void make_room();

  std::mutex mutex_;
  std::size_t most_bytes_ = 0;
  std::list<Entry> entries_; ///< most recently used first
};

/// Of compliance and responses [bytes].
std::size_t bytes_of(const StoredPosition& position);

} // namespace ionskin::mechanics
