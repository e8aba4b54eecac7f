// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/study/store/mechanics_record.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace ionskin::study {

/// Writes the record of Study 1 into a new results.h5: the strain history under /strain, maps under
/// /contact, forces per sample under /path, and the coarser solutions under /companions.
/// @param hash `mechanics_hash` of the case, of everything that decides Study 1
/// @param progress receives the activity "strain history"
void write_mechanics(const std::filesystem::path& path, const std::string& hash,
                     const MechanicsRecord& record,
                     const base::ProgressCallback& progress = base::no_progress);

/// Reads the record of Study 1 from a results.h5. Empty when the file is missing or holds the
/// mechanics of another case.
/// @param hash `mechanics_hash` of the case
/// @param skin whose core the strain history must cover
/// Throws UserError when the file is damaged.
std::optional<MechanicsRecord> read_mechanics(const std::filesystem::path& path,
                                              const std::string& hash, const Skin& skin);

} // namespace ionskin::study
