// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/history/core_history.hpp"

#include <vector>

namespace ionskin::electrochemistry {

/// Landings: instants on which time steps must end. These are the kinks of the strain history, that
/// is its samples and events, switches of a scan, and the instants at which fields are stored.
struct StepLandings {
  std::vector<double> time;   ///< landings [s], ascending, first to last sample of the history
  std::vector<bool> is_event; ///< true if the response has a fresh fast transient after it
  std::vector<bool> is_field; ///< true if the fields are stored there

  /// Finds the index of the first landing after an instant [s].
  std::size_t behind(double instant) const;
};

/// Makes the landings of a strain history, without duplicates.
/// @param field_times instants at which fields are stored [s]; those outside the history move to
///   its ends
/// @param switches instants within the history at which circuits change [s]; they count as events
StepLandings make_step_landings(const history::CoreHistory& history,
                                const std::vector<double>& field_times,
                                const std::vector<double>& switches = {});

} // namespace ionskin::electrochemistry
