// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/study/run/run_case.hpp"
#include "ionskin/study/sweep/sweep_points.hpp"

#include <cstddef>
#include <vector>

namespace ionskin::study {

/// Points of a sweep that one process solves together, with estimates of their cost. Made by
/// `plan_batches`.
struct SweepBatch {
  std::vector<std::size_t> points; ///< indices of the points, from 0, ascending
  /// Number of contact solutions, which share a skin; 0 where the strain is given.
  std::size_t solutions = 0;
  int threads = 1;    ///< number of threads that the estimates are for
  double memory = 0;  ///< estimated peak memory [bytes]; 0 where not known
  double seconds = 0; ///< estimated wall time [s]; 0 where not known
};

/// Divides all points of a sweep into batches. Points that share a skin stay together, unless
/// solving the skin again in another batch costs less than a quarter of the work that depends on
/// it. Points with a given strain, whose cost is not known, are batches by themselves.
/// @param threads number of threads for each batch
std::vector<SweepBatch> plan_batches(const std::vector<SweepPoint>& points, Studies studies,
                                     int threads);

} // namespace ionskin::study
