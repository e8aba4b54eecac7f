// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/live/training/full_run.hpp"

#include <string>
#include <vector>

namespace ionskin::live {

/// Errors of one signal of the reduced-order model against the full model, touch by touch, over
/// whole touches or over one of their events.
struct TouchErrors {
  std::string name;
  std::string event; ///< from `event::names`; empty: the whole touch
  /// Largest value of the full model over all touches [unit of the signal].
  double largest = 0;
  /// Rms error and largest error in each touch that has the event [unit of the signal].
  std::vector<double> rms, worst;
};

/// Steps the reduced-order skin along the motion of a full run of random touches, each millisecond,
/// and compares its signals with those of the full run; currents over the case's sampling interval.
/// If forces press the slider, the steps take the forces that the full run reached. The first
/// touch, which every training contains, is left out.
std::vector<TouchErrors> validate(const SkinData& data, const FullRun& run);

} // namespace ionskin::live
