// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/base/progress.hpp"
#include "ionskin/case/case.hpp"
#include "ionskin/mechanics/output/contact_solution.hpp"
#include "ionskin/mesh/footprint.hpp"

#include <optional>
#include <vector>

namespace ionskin::mechanics {

/// Footprint of a slider, found by `find_footprint`.
struct FoundFootprint {
  mesh::Footprint footprint;
  /// True if the footprint holds for all friction coefficients with the same `footprint_friction`;
  /// under a slider with sharp edges it holds for all coefficients.
  bool shared = false;
};

/// Finds the footprint of a slider: the rectangle that its contact will need. Under a slider with
/// sharp edges it is the slider's plan. For any other slider the search starts from
/// `mesh::largest_footprint` and solves touchdown and steady sliding at both ends of the track at
/// the preset `coarse`. The footprint shrinks until the contact fills most of it, grows where the
/// contact reaches its border, and keeps a margin. Its rims are rounded up to a geometric grid, so
/// that similar cases share one mesh. The search uses `footprint_friction(friction)`, so that the
/// footprint does not depend on the other coefficients of a run. Where that has no solution, or its
/// contact leaves the skin, the search uses `friction` itself.
/// @param friction coefficient of friction [1]
/// @param threads number of threads for the ends of the track
/// @param progress called from one thread at a time, with "contact footprint"; not called under
///   sharp edges
/// Throws UserError when the contact reaches the edge of the skin, SolverError when no footprint is
/// found.
FoundFootprint find_footprint(const Case& input, double friction, int threads,
                              const base::ProgressCallback& progress = base::no_progress);

/// Rounds a friction coefficient up to the next of 0, 0.5, 1, 2, 4, ... [1]. Coefficients with one
/// result can share a footprint.
double footprint_friction(double friction);

/// Larger footprint to solve on again, where the contact in any state of a solution reaches the
/// border of its footprint. Empty where it does so nowhere, or where the slider ends at that
/// border. Throws UserError when the contact reaches the edge of the skin.
std::optional<mesh::Footprint> widened_footprint(const Case& input,
                                                 const mesh::Footprint& footprint,
                                                 const ContactSolution& solution);

} // namespace ionskin::mechanics
