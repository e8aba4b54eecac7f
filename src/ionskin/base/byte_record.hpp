// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstring>
#include <span>
#include <type_traits>
#include <vector>

namespace ionskin::base {

/// Reader of a sequence of binary values in this machine's byte order, in the order in which they
/// were written. A read beyond the end of the bytes takes nothing and returns false.
class ByteReader {
public:
  explicit ByteReader(std::span<const std::byte> bytes) : rest_(bytes) {}

  template <class T>
  requires std::is_trivially_copyable_v<T>
  bool take(T& value) { return take_bytes(&value, sizeof(T)); }
  /// Reads as many values as `values` has entries, into `values`.
  template <class T> bool take_known(std::vector<T>& values) {
    return values.empty() || take_bytes(values.data(), values.size() * sizeof(T));
  }
  bool at_end() const { return rest_.empty(); }

private:
  bool take_bytes(void* to, std::size_t count) {
    if (rest_.size() < count) {
      return false;
    }
    std::memcpy(to, rest_.data(), count);
    rest_ = rest_.subspan(count);
    return true;
  }

  std::span<const std::byte> rest_;
};

} // namespace ionskin::base
