// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/mechanics/solve_contact.hpp"
#include "ionskin/mesh/footprint.hpp"
#include "ionskin/parallel/shared_progress.hpp"

#include <optional>
#include <vector>

namespace ionskin::mechanics {

/// Study 1 of a variant on one footprint.
struct SteppedSolution {
  ContactSolution contact;              ///< nothing of it where it needs a wider footprint
  std::optional<mesh::Footprint> wider; ///< footprint that it needs: its contact reached the border
};

/// Study 1 on one footprint, one solution per variant, which share the skin.
std::vector<SteppedSolution> solve_stepped(const Case& input, const mesh::Footprint& footprint,
                                           const std::vector<ContactVariant>& variants,
                                           const ContactOptions& options, base::Timers& timers,
                                           parallel::SharedProgress& progress);

} // namespace ionskin::mechanics
