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

/// 128 bits that stand for the content they were made of.
struct Digest {
  std::uint64_t high = 0, low = 0;
  bool operator==(const Digest&) const = default;
  std::string hex() const; ///< 32 lower-case digits
};

/// Digests a sequence of values bit by bit, by XXH3 with 128 bits (library xxHash, Y. Collet).
class DigestBuilder {
public:
  DigestBuilder();
  ~DigestBuilder();

  DigestBuilder& add_bytes(std::span<const std::byte> bytes);
  /// Numbers and enumerations, by their bits.
  template <class T>
  requires(std::is_arithmetic_v<T> || std::is_enum_v<T>) DigestBuilder& add(T value) {
    return add_bytes(std::as_bytes(std::span(&value, 1)));
  }
  /// Texts and vectors are preceded by their lengths, so that no two sequences look the same.
  DigestBuilder& add(std::string_view text);
  template <class T> DigestBuilder& add(const std::vector<T>& values) {
    add(values.size());
    return add_bytes(std::as_bytes(std::span(values)));
  }
  Digest finish() const;

private:
  struct State;
  std::unique_ptr<State> state_;
};

} // namespace ionskin::base
