// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/mesh/footprint.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace ionskin::planning {

/// Judges a contact case by its estimated size before any of it is built.
/// Throws UserError when it needs more memory than there is (base::available_memory), more unknowns
/// than can be counted, or more time steps than ever end; with the numbers and the remedy.
/// @param found see `estimate_cost`
void require_resources(const Case& input, int threads,
                       const std::optional<mesh::Footprint>& found = std::nullopt);

/// Throws UserError when files of so many bytes have no room on the disk of a folder
/// (base::available_disk), with both numbers and the remedy.
/// @param bytes see `expected_output`
void require_disk(double bytes, const std::filesystem::path& folder);

/// Complaint of `require_resources` as a sentence, empty where all is well. For checks on a machine
/// that need not be the one that runs the case. Throws UserError for what no machine can do.
std::string shortage(const Case& input, int threads,
                     const std::optional<mesh::Footprint>& found = std::nullopt);

} // namespace ionskin::planning
