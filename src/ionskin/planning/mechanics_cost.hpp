// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/mesh/footprint.hpp"

#include <cstddef>
#include <optional>

namespace ionskin::planning {

/// Size of Study 1, and what it will cost.
struct MechanicsCost {
  std::size_t contact_cells = 0; ///< below the slider, each with three components
  std::size_t steps = 0;         ///< of the contact along the path
  double seconds = 0;            ///< wall time, the handover of the strain included
  double further_seconds = 0; ///< more wall time for another friction coefficient on the same skin
  double memory = 0;          ///< largest, beside what the program takes at rest [bytes]
  double histories = 0;       ///< strain of run and coarser solutions, in memory to the end [bytes]
};

/// Cost of the run and, where it estimates its errors, of the coarser solutions that it solves
/// before.
/// @param found see `estimate_cost`
/// Throws UserError when no cells fit beside the slider.
MechanicsCost estimate_mechanics_cost(const Case& input, int threads,
                                      const std::optional<mesh::Footprint>& found);

} // namespace ionskin::planning
