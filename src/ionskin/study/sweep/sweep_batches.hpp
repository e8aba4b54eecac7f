// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/study/run/run_case.hpp"
#include "ionskin/study/sweep/sweep_points.hpp"

#include <cstddef>
#include <vector>

namespace ionskin::study {

/// Points of a sweep that are solved together, by one process.
struct SweepBatch {
  std::vector<std::size_t> points; ///< from 0, ascending
  std::size_t solutions = 0;       ///< contact solutions, which share a skin
  int threads = 1;
  double memory = 0;  ///< estimated [bytes]
  double seconds = 0; ///< wall time, estimated
};

/// All points in batches: those that share a skin stay together as far
/// as solving it again in another batch would cost more than a quarter of what hangs on it. Points
/// with a strain of their own, whose cost is not known, are batches by themselves.
/// @param threads of a batch
std::vector<SweepBatch> plan_batches(const std::vector<SweepPoint>& points, Studies studies,
                                     int threads);

} // namespace ionskin::study
