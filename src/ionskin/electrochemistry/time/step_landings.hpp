// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/history/core_history.hpp"

#include <vector>

namespace ionskin::electrochemistry {

/// Instants on which time steps must end: the kinks of the strain history, that is its samples and
/// events, and those at which the fields are kept.
struct StepLandings {
  std::vector<double> time;   ///< [s], ascending, first to last sample of the history
  std::vector<bool> is_event; ///< the response has a fresh fast transient after it
  std::vector<bool> is_field; ///< the fields are kept there

  /// Index of the first landing behind an instant.
  std::size_t behind(double instant) const;
};

/// Landings of a history, without duplicates.
/// @param field_times where the fields are kept [s]; instants outside the history move to its ends
/// @param switches instants within the history at which circuits change [s], which are events
StepLandings make_step_landings(const history::CoreHistory& history,
                                const std::vector<double>& field_times,
                                const std::vector<double>& switches = {});

} // namespace ionskin::electrochemistry
