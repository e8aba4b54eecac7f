// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/study/store/mechanics_record.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace ionskin::study {

/// Writes what Study 1 leaves into a new results.h5: /strain, /contact and /path (forces per
/// sample), and those of the coarser solutions below /companions.
/// @param hash of everything that decides Study 1, see `mechanics_hash`
/// @param progress called with "strain history"
void write_mechanics(const std::filesystem::path& path, const std::string& hash,
                     const MechanicsRecord& record,
                     const base::ProgressCallback& progress = base::no_progress);

/// Reads the mechanics of a case back; empty when the file is not there or holds the mechanics of
/// another case.
std::optional<MechanicsRecord> read_mechanics(const std::filesystem::path& path,
                                              const std::string& hash, const Skin& skin);

} // namespace ionskin::study
