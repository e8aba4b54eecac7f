// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/history/core_history.hpp"
#include "ionskin/mesh/footprint.hpp"

#include <cstddef>
#include <optional>

namespace ionskin::planning {

/// Size of both studies of a case, and what they will cost; of Study 2 alone where the load is
/// prescribed.
struct CostEstimate {
  std::size_t contact_cells = 0; ///< below the slider, each with three components
  std::size_t contact_steps = 0; ///< estimated
  std::size_t ion_unknowns = 0;
  std::size_t ion_steps = 0;    ///< estimated
  double memory = 0;            ///< largest resident [bytes]
  double output = 0;            ///< files [bytes]
  double mechanics_seconds = 0; ///< wall time of Study 1
  double further_seconds = 0;   ///< more of it for another friction coefficient on the same skin
  double ion_seconds = 0;       ///< wall time of Study 2
  double seconds = 0;           ///< wall time of both, with files and report
};

/// Estimate of time and memory of a case, without solving it.
/// @param threads that will run
/// @param found the slider's footprint where a coarse solution found it; without, the cells under
/// a round slider are a guess
/// Throws UserError when no cells fit beside the slider.
CostEstimate estimate_cost(const Case& input, int threads,
                           const std::optional<mesh::Footprint>& found = std::nullopt);

/// Cost of Study 2 alone, under a given strain; Study 1 has no cells then.
CostEstimate estimate_cost(const Case& input, const history::CoreHistory& given, int threads);

} // namespace ionskin::planning
