// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"

#include <cstddef>
#include <functional>

namespace ionskin::mechanics {

/// Steps that the contact is expected to take along a cycle of a motion.
struct ExpectedSteps {
  std::size_t taken = 0;
  std::size_t kept = 0; ///< of which the strain is kept
  /// Number of those taken at a place across the skin where the slider was not in the step before.
  std::size_t across = 0;
  double of_places = 0; ///< sum over those taken of what the place of each costs
};
/// Estimate of the steps along the motion of a case, without solving it.
/// @param cost of a step with the slider's centre at so much along the skin [m]
ExpectedSteps expected_steps(const Case& input, const std::function<double(double x)>& cost = {});

} // namespace ionskin::mechanics
