// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/base/files/disk_cache.hpp"
#include "ionskin/study/run/run_case.hpp"

#include <memory>

namespace ionskin::study {

/// The user's cache of condensed slider positions; null when the options or the environment turn it
/// off. Throws UserError when its settings are wrong.
std::unique_ptr<base::DiskCache> open_user_cache(const RunOptions& options);

} // namespace ionskin::study
