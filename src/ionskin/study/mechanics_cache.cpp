// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/mechanics_cache.hpp"

#include "ionskin/results/atomic_file.hpp"
#include "ionskin/study/mechanics_file.hpp"

#include <dlfcn.h>

#include <fstream>
#include <iterator>
#include <span>

namespace ionskin::study {
namespace {

std::string content_of(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// The program or module that holds this code, so that no build takes up what another computed.
std::string own_code() {
  Dl_info info{};
  dladdr(reinterpret_cast<const void*>(&keep_mechanics), &info);
  return info.dli_fname != nullptr ? content_of(info.dli_fname) : "";
}

base::Digest key_of(const std::string& hash) {
  static const base::Digest code = base::DigestBuilder().add(own_code()).finish();
  return base::DigestBuilder().add("mechanics").add(code.hex()).add(hash).finish();
}

} // namespace

void keep_mechanics(base::DiskCache& cache, const std::string& hash,
                    const std::filesystem::path& file) {
  const std::string content = content_of(file);
  cache.write(key_of(hash), {std::as_bytes(std::span(content))});
}

std::optional<MechanicsRecord> recall_mechanics(base::DiskCache& cache, const std::string& hash,
                                                const Skin& skin,
                                                const std::filesystem::path& file) {
  const auto content = cache.read(key_of(hash));
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
