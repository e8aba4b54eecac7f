// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/history/core_history.hpp"
#include "ionskin/mesh/footprint.hpp"

#include <cstddef>
#include <optional>
#include <string>

namespace ionskin::planning {

/// Estimated size and cost of both studies of a case. Where the load is prescribed or a strain
/// history is given, Study 1 is not solved and its numbers are 0.
struct CostEstimate {
  /// Contact cells below the slider, each with three force components.
  std::size_t contact_cells = 0;
  std::size_t contact_steps = 0; ///< load steps of the contact, estimated
  /// Unknowns of the ion transport: concentrations and potentials.
  std::size_t ion_unknowns = 0;
  std::size_t ion_steps = 0;    ///< time steps of the ion transport, estimated
  double memory = 0;            ///< peak resident memory of the process [bytes]
  double output = 0;            ///< size of the result files [bytes]
  double mechanics_seconds = 0; ///< wall time of Study 1 [s]
  /// Additional wall time of Study 1 for each further friction coefficient on the same skin [s].
  double further_seconds = 0;
  double ion_seconds = 0; ///< wall time of Study 2 [s]
  double seconds = 0;     ///< wall time of the whole run, including files and report [s]
};

/// Estimates time, memory and output of a case without solving it.
/// @param threads that the run will use
/// @param found footprint of the contact from a coarse solution; empty: the number of cells under a
/// round slider is a guess
/// Throws UserError when no contact cells fit beside the slider.
CostEstimate estimate_cost(const Case& input, int threads,
                           const std::optional<mesh::Footprint>& found = std::nullopt);

/// Estimates the cost of Study 2 under a given strain history, such as that of a strain file; the
/// numbers of Study 1 are 0.
/// @param given strain history that drives the ions
/// @param threads that the run will use
CostEstimate estimate_cost(const Case& input, const history::CoreHistory& given, int threads);

/// Sentence that announces a run of more than five minutes and says what takes less; empty for a
/// shorter one.
std::string announced_time(const Case& input, const CostEstimate& cost);

} // namespace ionskin::planning
