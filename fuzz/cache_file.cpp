// SPDX-License-Identifier: Apache-2.0

// Any bytes are a whole entry of the cache or a damaged one.

#include "ionskin/base/files/cache_file.hpp"
#include "scratch_file.hpp"

#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace ionskin::base;
  const ionskin::fuzz::ScratchFile file(data, size);
  const CacheFileContent found = read_cache_file(file.path(), Digest{});
  const bool whole = found.state == CacheFileState::whole;
  if (found.state == CacheFileState::absent || (!whole && !found.content.empty()) ||
      found.content.size() > size) {
    std::abort();
  }
  return 0;
}
