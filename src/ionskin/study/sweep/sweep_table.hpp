// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/readout/metrics.hpp"
#include "ionskin/study/sweep/sweep_points.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace ionskin::study {

/// Status of a point: not solved yet, finished, or failed.
enum class PointStatus { pending, finished, failed };

/// Status of one point of a sweep, with its metrics or the reason of its failure.
struct PointState {
  PointStatus status = PointStatus::pending;
  std::string reason;                   ///< reason of a failure; empty otherwise
  std::vector<readout::Metric> metrics; ///< metrics of a finished point; empty otherwise
};

/// Text of sweep.csv: one row per point with its number, folder, swept values in SI units, status,
/// reason and every metric; units in the header. Texts are quoted where CSV needs it (RFC 4180).
/// @param states one per point
std::string sweep_table_text(const std::vector<SweepPoint>& points,
                             const std::vector<PointState>& states);

/// Writes sweep.h5 from the run folders of the finished points. It has the groups signals, sampled,
/// taxels, circuit, water, sampled_taxels and sampled_circuit as in results.h5 under /points/NAME,
/// as far as a point has them, with the swept values as attributes; and one array over all points
/// for each key under /swept and each metric under /metrics, NaN where a point has no such metric.
/// @param folder of the sweep
/// @param target path of the new file
/// @param states one per point
void write_sweep_signals(const std::filesystem::path& folder, const std::filesystem::path& target,
                         const std::vector<SweepPoint>& points,
                         const std::vector<PointState>& states);

} // namespace ionskin::study
