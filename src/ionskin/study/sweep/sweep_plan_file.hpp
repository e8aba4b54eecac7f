// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/study/sweep/sweep_batches.hpp"
#include "ionskin/study/sweep/sweep_points.hpp"

#include <filesystem>
#include <optional>
#include <vector>

namespace ionskin::study {

/// Contents of plan.json: everything that doing a batch and collecting the tables need.
struct PlannedSweep {
  SweepPlan plan;
  std::vector<SweepBatch> batches;
  Studies studies = Studies::both;
};

/// The JSON text of a plan of this build.
std::string plan_text(const SweepPlan& plan, const std::vector<SweepBatch>& batches,
                      Studies studies);

/// Reads plan.json of a sweep's folder. The cases of the points are read and checked for one batch
/// only, or for none.
/// @param batch number from 0
/// Throws UserError: there is no plan, it is damaged or of another build, there is no such batch,
/// or a file that the case names is not what it was.
PlannedSweep read_planned_sweep(const std::filesystem::path& folder,
                                std::optional<std::size_t> batch);

} // namespace ionskin::study
