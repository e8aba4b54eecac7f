// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/electrochemistry/output/ion_solution.hpp"
#include "ionskin/history/core_history.hpp"
#include "ionskin/live/training/charge_fit.hpp"
#include "ionskin/live/training/train.hpp"
#include "ionskin/mechanics/output/contact_solution.hpp"
#include "ionskin/mesh/footprint.hpp"

#include <optional>
#include <vector>

namespace ionskin::live {

/// The full model along one motion.
struct FullRun {
  Case input;
  mechanics::ContactSolution contact;
  history::CoreHistory history;
  electrochemistry::IonSolution ions;
};

/// Runs the full model along a motion. Throws SolverError where it has no solution.
/// @param motion in place of the case's
/// @param footprint of an earlier run with the same loads; empty to find it
FullRun full_run(const Case& input, const Motion& motion,
                 const std::optional<mesh::Footprint>& footprint, const TrainingOptions& options);

/// The charges of the whole electrode, or of the taxels, and their inputs: integrals of the
/// driving channel over the area, by level; where the law knows the mean over the core also those
/// of the whole core times the region's share of it.
std::vector<ChargeRecord> charge_records(const FullRun& run, bool of_taxels);
/// Numbers in a row of their drive.
std::size_t drive_inputs(const FullRun& run, bool of_taxels);

} // namespace ionskin::live
