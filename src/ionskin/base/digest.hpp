// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace ionskin::base {

/// 128-bit hash of some content, as `DigestBuilder` makes it. It is not cryptographic.
struct Digest {
  std::uint64_t high = 0, low = 0; ///< upper and lower 64 bits
  bool operator==(const Digest&) const = default;
  std::string hex() const; ///< 32 lower-case hexadecimal digits
};

/// Incremental hash of a sequence of values by their bits: XXH3 with 128 bits (library xxHash,
/// Y. Collet).
class DigestBuilder {
public:
  DigestBuilder();
  ~DigestBuilder();

  /// Adds bytes, without their number.
  DigestBuilder& add_bytes(std::span<const std::byte> bytes);
  /// Adds the bits of a number or an enumeration value.
  template <class T>
  requires(std::is_arithmetic_v<T> || std::is_enum_v<T>) DigestBuilder& add(T value) {
    return add_bytes(std::as_bytes(std::span(&value, 1)));
  }
  /// Adds a text or a vector after its length, so that different sequences do not give the same
  /// bytes.
  DigestBuilder& add(std::string_view text);
  template <class T> DigestBuilder& add(const std::vector<T>& values) {
    add(values.size());
    return add_bytes(std::as_bytes(std::span(values)));
  }
  /// Digest of everything added so far.
  Digest finish() const;

private:
  struct State;
  std::unique_ptr<State> state_;
};

} // namespace ionskin::base
