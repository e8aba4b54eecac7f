// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/mesh/footprint.hpp"

#include <optional>
#include <string>
#include <vector>

namespace ionskin::planning {

/// Warnings that the scales and the estimated contact of a case give before it runs: a fixed charge
/// below zero, released ions without room, a net charge that no ion can screen, ions or samples too
/// slow for the contact, no coupling, a strain that is not small. Each a sentence with its remedy.
/// Throws UserError where the run is bound to fail: where the least shear leaves no solution. Empty
/// where no slider makes the strain.
/// @param found the contact where a coarse solution has found it
std::vector<std::string> foreseen(const Case& input,
                                  const std::optional<mesh::Footprint>& found = std::nullopt);

} // namespace ionskin::planning
