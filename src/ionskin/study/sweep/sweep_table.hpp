// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/readout/metrics.hpp"
#include "ionskin/study/sweep/sweep_points.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace ionskin::study {

/// Status of a point.
enum class PointStatus { pending, finished, failed };

/// State of one point of a sweep.
struct PointState {
  PointStatus status = PointStatus::pending;
  std::string reason;                   ///< reason why it failed
  std::vector<readout::Metric> metrics; ///< of a finished point
};

/// sweep.csv as text: one row per point with its number, folder, swept values in SI, status, reason
/// and every metric, units in the header. Texts are quoted where CSV needs it (RFC 4180).
std::string sweep_table_text(const std::vector<SweepPoint>& points,
                             const std::vector<PointState>& states);

/// sweep.h5, at `target`, from the folders of the finished points: under /points/NAME the groups
/// signals, sampled, taxels and circuit as in results.h5, as far as they are there, with the swept
/// values as attributes; under /swept and /metrics one array over all points each, NaN where a
/// point has none.
void write_sweep_signals(const std::filesystem::path& folder, const std::filesystem::path& target,
                         const std::vector<SweepPoint>& points,
                         const std::vector<PointState>& states);

} // namespace ionskin::study
