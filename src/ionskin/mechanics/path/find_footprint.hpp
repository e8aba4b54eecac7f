// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/base/progress.hpp"
#include "ionskin/case/case.hpp"
#include "ionskin/mechanics/output/contact_solution.hpp"
#include "ionskin/mesh/footprint.hpp"

#include <optional>
#include <vector>

namespace ionskin::mechanics {

struct FoundFootprint {
  mesh::Footprint footprint;
  /// True if it holds for all friction coefficients with the same `footprint_friction`, and under a
  /// sharp slider for all.
  bool shared = false;
};

/// The footprint that a slider will have. That of a sharp one is its plan. That of any other is
/// found from `mesh::largest_footprint` by solving touchdown and steady sliding at both ends of the
/// track at the coarse preset: it shrinks until the contact fills most of it, grows where the
/// contact reaches its border, and keeps a margin. Rims are rounded up to a geometric grid, so that
/// cases that differ little share one mesh. It is that of the next `footprint_friction`, lest it
/// depend on what else is solved; where the contact there has no solution or leaves the skin, of
/// the given coefficient alone.
/// @param threads for the ends of the track
/// @param progress called from one thread at a time, with "contact footprint"; not for a sharp one
/// Throws UserError when the contact reaches the edge of the skin.
FoundFootprint find_footprint(const Case& input, double friction, int threads,
                              const base::ProgressCallback& progress = base::no_progress);

/// The next of 0, 0.5, 1, 2: coefficients with the same one can share a footprint.
double footprint_friction(double friction);

/// A larger footprint when the contact of any state reaches the border of this one, which it should
/// not; empty when it nowhere does, or the slider ends there.
std::optional<mesh::Footprint> widened_footprint(const Case& input,
                                                 const mesh::Footprint& footprint,
                                                 const ContactSolution& solution);

} // namespace ionskin::mechanics
