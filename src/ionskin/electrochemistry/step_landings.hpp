// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/strain/strain_history.hpp"

#include <vector>

namespace ionskin::electrochemistry {

/// Instants on which time steps must end: the kinks of the strain history, that is its samples and
/// events, and whatever else is wanted.
struct StepLandings {
  std::vector<double> time;   ///< [s], ascending, first to last sample of the history
  std::vector<bool> is_event; ///< the response has a fresh fast transient after it

  /// Index of the first landing behind an instant.
  std::size_t behind(double instant) const;
};

/// @param wanted further instants [s]; those outside the history move to its ends
StepLandings make_step_landings(const strain::StrainHistory& history,
                                const std::vector<double>& wanted);

} // namespace ionskin::electrochemistry
