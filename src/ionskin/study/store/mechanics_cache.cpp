// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/store/mechanics_cache.hpp"

#include "ionskin/base/files/atomic_file.hpp"
#include "ionskin/study/store/mechanics_file.hpp"

#include <cstdint>
#include <fstream>
#include <span>
#include <system_error>
#include <utility>

namespace ionskin::study {
namespace {

/// Larger histories are of paths so long that an entry would drive out all others, and are held in
/// memory while it is written.
constexpr std::uintmax_t largest_kept = 500'000'000;

/// Nothing when the file cannot be read or is too large to be kept.
std::optional<std::string> content_of(const std::filesystem::path& path) {
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (error || size > largest_kept) {
    return std::nullopt;
  }
  std::string content(size, '\0');
  std::ifstream stream(path, std::ios::binary);
  stream.read(content.data(), static_cast<std::streamsize>(size));
  return stream ? std::optional(std::move(content)) : std::nullopt;
}

base::Digest key_of(const std::string& hash, const base::Digest& build) {
  return base::DigestBuilder().add("mechanics").add(build.hex()).add(hash).finish();
}

} // namespace

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
  base::PendingFile copy(file);
  copy.write(*content);
  copy.commit();
  return read_mechanics(file, hash, skin);
}

} // namespace ionskin::study
