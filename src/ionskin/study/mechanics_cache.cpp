// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/mechanics_cache.hpp"

#include "ionskin/linear_algebra/dense_kernels.hpp"
#include "ionskin/results/atomic_file.hpp"
#include "ionskin/study/mechanics_file.hpp"

#include <dlfcn.h>
#include <link.h>

#include <cstdint>
#include <fstream>
#include <span>
#include <system_error>
#include <utility>

namespace ionskin::study {
namespace {

/// Nothing when the file cannot be read.
std::optional<std::string> content_of(const std::filesystem::path& path) {
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (error) {
    return std::nullopt;
  }
  std::string content(size, '\0');
  std::ifstream stream(path, std::ios::binary);
  stream.read(content.data(), static_cast<std::streamsize>(size));
  return stream ? std::optional(std::move(content)) : std::nullopt;
}

/// The program or module that holds this code.
std::filesystem::path own_file() {
  Dl_info info{};
  link_map* object = nullptr;
  dladdr1(reinterpret_cast<const void*>(&keep_mechanics), &info, reinterpret_cast<void**>(&object),
          RTLD_DL_LINKMAP);
  // The program itself has no name there, and its first argument may name another file.
  const bool module = object != nullptr && object->l_name != nullptr && *object->l_name != '\0';
  return module ? object->l_name : "/proc/self/exe";
}

base::Digest key_of(const std::string& hash, const base::Digest& build) {
  return base::DigestBuilder()
      .add("mechanics")
      .add(build.hex())
      .add(linear_algebra::kernel_name())
      .add(hash)
      .finish();
}

} // namespace

std::optional<base::Digest> build_digest(const std::filesystem::path& program) {
  const auto code = content_of(program);
  return code ? std::optional(base::DigestBuilder().add(*code).finish()) : std::nullopt;
}

const std::optional<base::Digest>& own_build() {
  static const std::optional<base::Digest> build = build_digest(own_file());
  return build;
}

void keep_mechanics(base::DiskCache& cache, const std::string& hash,
                    const std::filesystem::path& file, const std::optional<base::Digest>& build) {
  const auto content = build ? content_of(file) : std::nullopt;
  if (content) {
    cache.write(key_of(hash, *build), {std::as_bytes(std::span(*content))});
  }
}

bool keeps_mechanics(const base::DiskCache& cache, const std::string& hash,
                     const std::optional<base::Digest>& build) {
  return build && cache.contains(key_of(hash, *build));
}

std::optional<MechanicsRecord> recall_mechanics(base::DiskCache& cache, const std::string& hash,
                                                const Skin& skin, const std::filesystem::path& file,
                                                const std::optional<base::Digest>& build) {
  const auto content = build ? cache.read(key_of(hash, *build)) : std::nullopt;
  if (!content) {
    return std::nullopt;
  }
  results::AtomicFile copy(file);
  copy.stream().write(reinterpret_cast<const char*>(content->data()),
                      static_cast<std::streamsize>(content->size()));
  copy.commit();
  return read_mechanics(file, hash, skin);
}

} // namespace ionskin::study
