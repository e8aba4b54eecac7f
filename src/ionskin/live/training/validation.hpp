// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/live/training/full_run.hpp"

#include <vector>

namespace ionskin::live {

/// Steps the reduced skin along the motion of a full run, each millisecond, and compares its
/// signals; currents over the case's sampling interval. Under force control the force is the one
/// that the full run reached.
std::vector<SignalError> validate(const SkinData& data, const FullRun& run);

} // namespace ionskin::live
