// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/mesh/footprint.hpp"

#include <optional>
#include <string>
#include <vector>

namespace ionskin::planning {

/// Predicts from the scales and the estimated contact of a case, before it runs, what will spoil
/// its results: a fixed charge below zero, released ions without room, a net charge that no ion can
/// screen, samples too coarse or ions too slow for the contact, no coupling, an indentation too
/// large for small strains.
/// @param found footprint of the contact from a coarse solution; empty to estimate it
/// @returns one sentence with its remedy for each; none where the strain is prescribed or comes
/// from a file
/// Throws UserError where the run is bound to fail: where even the lower bound of the shear leaves
/// no solution, or where several sliders are too close to each other.
std::vector<std::string> foreseen(const Case& input,
                                  const std::optional<mesh::Footprint>& found = std::nullopt);

} // namespace ionskin::planning
