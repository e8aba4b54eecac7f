// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/live/training/full_run.hpp"

#include <string>
#include <vector>

namespace ionskin::live {

/// Errors of one signal of the reduced skin against that of the full model, touch by touch, over
/// the whole of the touches or over one of their events.
struct TouchErrors {
  std::string name;
  std::string event;  ///< by `event::names`; empty: the whole touch
  double largest = 0; ///< of the full model over all of them [unit of the signal]
  /// Errors in each touch that has the event [unit of the signal].
  std::vector<double> rms, worst;
};

/// Steps the reduced skin along the motion of a full run of random touches, each millisecond, and
/// compares its signals; currents over the case's sampling interval. Under force control the force
/// is the one that the full run reached. The first touch, which every training has, is left out.
std::vector<TouchErrors> validate(const SkinData& data, const FullRun& run);

} // namespace ionskin::live
