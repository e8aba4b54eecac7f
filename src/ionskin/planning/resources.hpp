// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/mesh/footprint.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace ionskin::planning {

/// Checks, before any work, that a case fits on this machine. A case with a strain file is not
/// checked.
/// @param threads that the run will use
/// @param found footprint of the contact from a coarse solution; empty to estimate it
/// Throws UserError when the case needs more memory than there is (`base::available_memory`), more
/// unknowns than 32-bit indices can count, or more time steps than could ever be finished; with the
/// numbers and the remedy.
void require_resources(const Case& input, int threads,
                       const std::optional<mesh::Footprint>& found = std::nullopt);

/// Checks that result files have room on a disk.
/// @param bytes expected size of the files, see `expected_output`
/// @param folder that the files go into
/// Throws UserError when the disk of the folder has less room (`base::available_disk`), with both
/// numbers and the remedy.
void require_disk(double bytes, const std::filesystem::path& folder);

/// Sentence that says how much memory a case lacks on this machine, with the remedy; empty where
/// there is enough. For checks on a machine that need not be the one that runs the case.
/// @param threads that the run will use
/// @param found footprint of the contact from a coarse solution; empty to estimate it
/// Throws UserError for what no machine can do: too many unknowns or time steps.
std::string shortage(const Case& input, int threads,
                     const std::optional<mesh::Footprint>& found = std::nullopt);

} // namespace ionskin::planning
