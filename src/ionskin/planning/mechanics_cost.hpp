// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/mesh/footprint.hpp"

#include <cstddef>
#include <optional>

namespace ionskin::planning {

/// Estimated size and cost of Study 1 (contact mechanics).
struct MechanicsCost {
  /// Contact cells below the slider, each with three force components.
  std::size_t contact_cells = 0;
  std::size_t steps = 0; ///< load steps of the contact along the path
  double seconds = 0;    ///< wall time, including the strain history [s]
  /// Additional wall time for each further friction coefficient on the same skin [s].
  double further_seconds = 0;
  double memory = 0; ///< peak memory, without what the idle program takes [bytes]
  /// Strain histories of the run and its coarser solutions, held to the end [bytes].
  double histories = 0;
};

/// Estimates the cost of Study 1 and, where the run estimates its errors, of the coarser solutions
/// that are solved for this.
/// @param threads that the run will use
/// @param found footprint of the contact from a coarse solution; empty: the number of cells under a
/// round slider is a guess
/// Throws UserError when no contact cells fit beside the slider.
MechanicsCost estimate_mechanics_cost(const Case& input, int threads,
                                      const std::optional<mesh::Footprint>& found);

} // namespace ionskin::planning
