// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace ionskin::base {

/// Values one behind the other, as their bytes on this machine.
class ByteWriter {
public:
  template <class T>
  requires std::is_trivially_copyable_v<T> ByteWriter& add(const T& value) {
    const auto bytes = std::as_bytes(std::span(&value, 1));
    bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
    return *this;
  }
  /// A list behind its length.
  template <class T> ByteWriter& add(const std::vector<T>& values) {
    add(static_cast<std::uint64_t>(values.size()));
    const auto bytes = std::as_bytes(std::span(values));
    bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
    return *this;
  }
  ByteWriter& add(const std::string& text) {
    return add(std::vector<char>(text.begin(), text.end()));
  }
  std::vector<std::byte> take() { return std::move(bytes_); }

private:
  std::vector<std::byte> bytes_;
};

/// Takes values back in the same order. What is asked for beyond the end is not taken: false.
class ByteReader {
public:
  explicit ByteReader(std::span<const std::byte> bytes) : rest_(bytes) {}

  bool take_bytes(void* to, std::size_t count) {
    if (rest_.size() < count) {
      return false;
    }
    std::memcpy(to, rest_.data(), count);
    rest_ = rest_.subspan(count);
    return true;
  }
  template <class T>
  requires std::is_trivially_copyable_v<T>
  bool take(T& value) { return take_bytes(&value, sizeof(T)); }
  /// A list behind its length.
  template <class T> bool take(std::vector<T>& values) {
    std::uint64_t count = 0;
    if (!take(count) || count > rest_.size() / sizeof(T)) {
      return false;
    }
    values.resize(static_cast<std::size_t>(count));
    return take_known(values);
  }
  /// A list whose length is known.
  template <class T> bool take_known(std::vector<T>& values) {
    return values.empty() || take_bytes(values.data(), values.size() * sizeof(T));
  }
  bool take(std::string& text) {
    std::vector<char> characters;
    const bool taken = take(characters);
    text.assign(characters.begin(), characters.end());
    return taken;
  }
  bool at_end() const { return rest_.empty(); }

private:
  std::span<const std::byte> rest_;
};

} // namespace ionskin::base
