// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/history/core_history.hpp"

#include <cstddef>

namespace ionskin::electrochemistry {

/// Size of Study 2 before it runs.
struct ProblemSize {
  std::size_t columns_x = 0, columns_y = 0, levels = 0;
  std::size_t unknowns = 0; ///< concentration and potential
  std::size_t steps = 0;    ///< estimate of the time steps, of two implicit stages each
  double memory = 0;        ///< estimate [bytes]
};

/// Size for a given history.
ProblemSize problem_size(const Case& input, const history::CoreHistory& history);

/// Estimate from the case alone, without a strain file and before Study 1: the grid is exact, the
/// steps are those that probable samples, events and the tolerance make.
ProblemSize estimate_problem_size(const Case& input);

} // namespace ionskin::electrochemistry
