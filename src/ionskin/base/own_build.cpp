// SPDX-License-Identifier: Apache-2.0
#include "ionskin/base/own_build.hpp"

#include <dlfcn.h>
#include <link.h>

#include <array>
#include <fstream>

namespace ionskin::base {
namespace {

/// The program or module that holds this code.
std::filesystem::path own_file() {
  Dl_info info{};
  link_map* object = nullptr;
  dladdr1(reinterpret_cast<const void*>(&own_build), &info, reinterpret_cast<void**>(&object),
          RTLD_DL_LINKMAP);
  // The program itself has no name there, and its first argument may name another file.
  const bool module = object != nullptr && object->l_name != nullptr && *object->l_name != '\0';
  return module ? object->l_name : "/proc/self/exe";
}

} // namespace

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
