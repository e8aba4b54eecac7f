// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/base/disk_cache.hpp"
#include "ionskin/study/mechanics_record.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace ionskin::study {

// Study 1 of an earlier run in the user's cache: a run that changes nothing but Study 2 takes it
// up. Only the very same build of the program finds it.

/// Keeps a file that `write_mechanics` wrote.
/// @param hash see `mechanics_hash`
void keep_mechanics(base::DiskCache& cache, const std::string& hash,
                    const std::filesystem::path& file);

/// Puts what was kept at `file` and reads it; nothing when nothing was kept.
std::optional<MechanicsRecord> recall_mechanics(base::DiskCache& cache, const std::string& hash,
                                                const Skin& skin,
                                                const std::filesystem::path& file);

} // namespace ionskin::study
