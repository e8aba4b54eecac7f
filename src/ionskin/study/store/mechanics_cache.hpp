// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/base/digest.hpp"
#include "ionskin/base/files/disk_cache.hpp"
#include "ionskin/base/system/own_build.hpp"
#include "ionskin/study/store/mechanics_record.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace ionskin::study {

// Study 1 of an earlier run in the user's cache: a run that changes nothing but Study 2 takes it
// up. Only the very same build of the program finds it, so that none takes up what another
// computed; a build that is not known neither keeps nor finds anything.

using base::own_build;

/// Keeps a file that `write_mechanics` wrote.
/// @param hash see `mechanics_hash`
void keep_mechanics(base::DiskCache& cache, const std::string& hash,
                    const std::filesystem::path& file,
                    const std::optional<base::Digest>& build = own_build());

/// Whether something was kept.
bool keeps_mechanics(const base::DiskCache& cache, const std::string& hash,
                     const std::optional<base::Digest>& build = own_build());

/// Puts what was kept at `file` and reads it; nothing when nothing was kept.
std::optional<MechanicsRecord>
recall_mechanics(base::DiskCache& cache, const std::string& hash, const Skin& skin,
                 const std::filesystem::path& file,
                 const std::optional<base::Digest>& build = own_build());

} // namespace ionskin::study
