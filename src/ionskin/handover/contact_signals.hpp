// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/handover/contact_timeline.hpp"

#include <vector>

namespace ionskin::handover {

/// Contact signals over one cycle, one entry per sample of the timeline; all 0 while the slider is
/// detached.
struct ContactSignals {
  std::vector<double> area;        ///< of the full skin [m2]
  std::vector<double> stick_share; ///< of it, where nothing slips, 0 to 1
  /// Length of the slip of the slider over the skin since it landed, the mean over the cells that
  /// touch, by their area [m].
  std::vector<double> slip;
};

ContactSignals contact_signals(const ContactTimeline& timeline,
                               const mechanics::ContactSolution& contact);

} // namespace ionskin::handover
