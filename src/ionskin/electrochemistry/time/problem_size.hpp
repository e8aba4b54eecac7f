// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/history/core_history.hpp"

#include <cstddef>

namespace ionskin::electrochemistry {

/// Size of Study 2, estimated before it runs: grid, time steps and memory.
struct ProblemSize {
  std::size_t columns_x = 0, columns_y = 0, levels = 0; ///< `levels` is 1 for thin layers
  std::size_t unknowns = 0;                             ///< number of concentrations and potentials
  std::size_t steps = 0; ///< estimated number of time steps, of two implicit stages each
  double memory = 0;     ///< estimated [bytes]
};

/// Estimates the size of Study 2 for a strain history; the grid is exact.
ProblemSize problem_size(const Case& input, const history::CoreHistory& history);

/// Estimates the size of Study 2 from the case only, without a strain file and before Study 1. The
/// grid is exact; the number of steps follows from the tolerance and from the samples and events
/// that the history is likely to have.
ProblemSize estimate_problem_size(const Case& input);

} // namespace ionskin::electrochemistry
