// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"

#include <cstddef>
#include <functional>

namespace ionskin::mechanics {

/// Estimated numbers of contact steps along one cycle of a motion, made by `expected_steps`.
struct ExpectedSteps {
  std::size_t taken = 0; ///< all steps
  std::size_t kept = 0;  ///< steps whose states and strains are stored
  /// Steps at a y where the slider was not in the step before. They compute anew what positions
  /// with the same y share.
  std::size_t across = 0;
  double of_places = 0; ///< sum of `cost` over all steps, in the unit of `cost`
};
/// Estimates the number of contact steps along the motion of a case, without a solution.
/// @param cost of one step as a function of the slider's x [m]; empty to leave `of_places` at 0
ExpectedSteps expected_steps(const Case& input, const std::function<double(double x)>& cost = {});

} // namespace ionskin::mechanics
