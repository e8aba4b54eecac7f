// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/handover/contact_timeline.hpp"

#include <vector>

namespace ionskin::handover {

/// Contact signals over one cycle, with one entry per sample of the timeline. All signals are 0
/// while the slider is detached.
struct ContactSignals {
  std::vector<double> area;        ///< contact area of the full skin [m2]
  std::vector<double> stick_share; ///< share of the contact area in which nothing slips, 0 to 1
  /// Path length that the slider has slipped over the skin since it landed: the sum over the
  /// samples of the slip in each, averaged by area over the cells that touch [m].
  std::vector<double> slip;
};

/// Calculates the contact signals at all samples of the timeline.
ContactSignals contact_signals(const ContactTimeline& timeline,
                               const mechanics::ContactSolution& contact);

} // namespace ionskin::handover
