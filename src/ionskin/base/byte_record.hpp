// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstring>
#include <span>
#include <type_traits>
#include <vector>

namespace ionskin::base {

/// Takes values from their bytes on this machine, in the order in which they were written. A read
/// beyond the end takes nothing and returns false.
class ByteReader {
public:
  explicit ByteReader(std::span<const std::byte> bytes) : rest_(bytes) {}

  template <class T>
  requires std::is_trivially_copyable_v<T>
  bool take(T& value) { return take_bytes(&value, sizeof(T)); }
  /// A list whose length is known.
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
