// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/mechanics/solve_contact.hpp"
#include "ionskin/mesh/footprint.hpp"
#include "ionskin/parallel/shared_progress.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace ionskin::mechanics {

/// Positions that a motion is expected to need; 0 when it never touches.
std::size_t expected_positions(const Case& input);
/// Lines of them along x and along y; one each when it never touches.
std::array<std::size_t, 2> expected_lines(const Case& input);

/// Study 1 of a variant on one footprint.
struct SteppedSolution {
  ContactSolution contact;              ///< nothing of it where it needs a wider footprint
  std::optional<mesh::Footprint> wider; ///< that it needs: its contact reached the border
};

/// Study 1 on one footprint, one solution per variant, which share their positions.
std::vector<SteppedSolution> solve_stepped(const Case& input, const mesh::Footprint& footprint,
                                           const std::vector<ContactVariant>& variants,
                                           const ContactOptions& options, base::Timers& timers,
                                           parallel::SharedProgress& progress);

} // namespace ionskin::mechanics
