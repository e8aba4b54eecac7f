// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/study/sweep/sweep_batches.hpp"
#include "ionskin/study/sweep/sweep_points.hpp"

#include <filesystem>
#include <optional>
#include <vector>

namespace ionskin::study {

/// Contents of plan.json: everything that is needed to solve a batch and to collect the tables.
struct PlannedSweep {
  SweepPlan plan;
  std::vector<SweepBatch> batches;
  Studies studies = Studies::both;
};

/// Text of plan.json, in JSON, with the build of this program.
/// Throws UserError when it would be too long.
std::string plan_text(const SweepPlan& plan, const std::vector<SweepBatch>& batches,
                      Studies studies);

/// Reads plan.json from a sweep's folder, and reads and checks the cases of the points of one
/// batch.
/// @param batch number from 0; empty: reads the case of no point, but the base case of the sweep
/// Throws UserError when there is no plan, it is damaged or of another build, there is no such
/// batch, or a file that a case names has changed.
PlannedSweep read_planned_sweep(const std::filesystem::path& folder,
                                std::optional<std::size_t> batch);

} // namespace ionskin::study
