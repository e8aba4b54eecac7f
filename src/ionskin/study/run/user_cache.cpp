// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/run/user_cache.hpp"

namespace ionskin::study {

std::unique_ptr<base::DiskCache> open_user_cache(const RunOptions& options) {
  if (!options.use_cache) {
    return nullptr;
  }
  const auto folder = base::cache_folder();
  const auto limit = base::cache_limit();
  return folder && limit > 0 ? std::make_unique<base::DiskCache>(*folder, limit) : nullptr;
}

} // namespace ionskin::study
