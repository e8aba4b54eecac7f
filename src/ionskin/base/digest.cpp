// SPDX-License-Identifier: Apache-2.0
#include "ionskin/base/digest.hpp"

#include <fmt/core.h>

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace ionskin::base {

std::string Digest::hex() const {
  return fmt::format("{:016x}{:016x}", high, low);
}

struct DigestBuilder::State {
  XXH3_state_t hash;
};

DigestBuilder::DigestBuilder() : state_(std::make_unique<State>()) {
  XXH3_128bits_reset(&state_->hash);
}

DigestBuilder::~DigestBuilder() = default;

DigestBuilder& DigestBuilder::add_bytes(std::span<const std::byte> bytes) {
  XXH3_128bits_update(&state_->hash, bytes.data(), bytes.size());
  return *this;
}

DigestBuilder& DigestBuilder::add(std::string_view text) {
  add(text.size());
  return add_bytes(std::as_bytes(std::span(text.data(), text.size())));
}

Digest DigestBuilder::finish() const {
  const XXH128_hash_t value = XXH3_128bits_digest(&state_->hash);
  return {value.high64, value.low64};
}

} // namespace ionskin::base
