// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/mechanics/solve_contact.hpp"
#include "ionskin/mesh/footprint.hpp"
#include "ionskin/parallel/shared_progress.hpp"

#include <optional>
#include <vector>

namespace ionskin::mechanics {

/// Result of Study 1 for one variant on a given footprint.
struct SteppedSolution {
  ContactSolution contact; ///< without instants if a wider footprint is needed
  /// Wider footprint to solve on, where the contact reached the border of the given one; else
  /// empty.
  std::optional<mesh::Footprint> wider;
};

/// Runs Study 1 for several variants on one footprint, on a common skin model.
/// @param progress counts the parts of the work that are done
/// @returns one solution for each variant, in their order
std::vector<SteppedSolution> solve_stepped(const Case& input, const mesh::Footprint& footprint,
                                           const std::vector<ContactVariant>& variants,
                                           const ContactOptions& options, base::Timers& timers,
                                           parallel::SharedProgress& progress);

} // namespace ionskin::mechanics
