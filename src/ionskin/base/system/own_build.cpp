// SPDX-License-Identifier: Apache-2.0
#include "ionskin/base/system/own_build.hpp"

#include "ionskin/base/system/installation.hpp"

#include <array>
#include <fstream>

namespace ionskin::base {
std::optional<Digest> build_digest(const std::filesystem::path& program) {
  std::ifstream stream(program, std::ios::binary);
  DigestBuilder builder;
  std::array<char, 65536> block;
  while (stream.read(block.data(), block.size()) || stream.gcount() > 0) {
    const auto part = std::span(block).first(static_cast<std::size_t>(stream.gcount()));
    builder.add_bytes(std::as_bytes(part));
  }
  return stream.eof() ? std::optional(builder.finish()) : std::nullopt;
}

const std::optional<Digest>& own_build() {
  static const std::optional<Digest> build = build_digest(own_file());
  return build;
}

} // namespace ionskin::base
