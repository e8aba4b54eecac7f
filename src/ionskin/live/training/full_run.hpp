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

/// Results of the full model along one motion: case with this motion, Study 1 (contact), transfer
/// of the strain, Study 2 (ions).
struct FullRun {
  Case input;
  mechanics::ContactSolution contact;
  history::CoreHistory history;
  electrochemistry::IonSolution ions;
};

/// Runs the full model along a motion. Throws SolverError where it has no solution.
/// @param motion replaces that of the case
/// @param footprint rectangle in which the slider may touch, from an earlier run with the same
/// loads; empty to find it
FullRun full_run(const Case& input, const Motion& motion,
                 const std::optional<mesh::Footprint>& footprint, const TrainingOptions& options);

/// Training records of the charges, with their inputs: integrals of the driving channel over the
/// region's area at each z level [m2]; for taxels under a law that depends on the mean over the
/// core, the integrals over the whole core times the region's share of its area follow.
/// @param of_taxels true for one record per taxel, false for one record of the whole electrode
std::vector<ChargeRecord> charge_records(const FullRun& run, bool of_taxels);
/// Number of inputs in a row of these records.
std::size_t drive_inputs(const FullRun& run, bool of_taxels);

} // namespace ionskin::live
