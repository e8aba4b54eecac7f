// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/base/progress.hpp"
#include "ionskin/base/timers.hpp"
#include "ionskin/case/case.hpp"
#include "ionskin/mechanics/output/contact_solution.hpp"
#include "ionskin/mechanics/output/force_path.hpp"
#include "ionskin/mechanics/path/path_steps.hpp"
#include "ionskin/mesh/footprint.hpp"
#include "ionskin/parallel/spare_threads.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace ionskin::mechanics {

/// Options of a run of Study 1.
struct ContactOptions {
  int threads = 1; ///< for the contact solutions
  /// Number of threads that build the skin model, for which all solutions on it wait, and that
  /// recover strains once all solutions are there; 0: `threads`.
  int shared_threads = 0;
  /// Source of threads without a task of their own, which help to recover strains while other
  /// solutions are still running; null: none.
  std::shared_ptr<parallel::SpareThreads> spare;
  base::ProgressCallback progress = base::no_progress; ///< called from one thread at a time
  /// Resolution of the load steps.
  PathSteps steps;
  /// Footprint that `find_footprint` found for these loads and this friction; where empty, it is
  /// found first.
  std::optional<mesh::Footprint> footprint;
  /// True to mesh the whole skin even where half of it would do, for comparison.
  bool full_model = false;
  /// Called with the solution up to where it failed, before a SolverError is thrown; null: not
  /// called.
  std::function<void(const ContactSolution&)> unfinished;
};

/// Values that may differ between several solutions on one skin model.
struct ContactVariant {
  double friction = 0; ///< coefficient of friction [1]
  PathSteps steps;
  /// Force paths of other sliders that press the same skin at the same time; null: none.
  std::shared_ptr<const std::vector<ForcePath>> others = {};
};

/// Runs Study 1 for the friction coefficient of the case. Throws SolverError when the contact does
/// not converge, UserError when it reaches the edge of the skin, Interrupted on request.
ContactSolution solve_contact(const Case& input, const ContactOptions& options,
                              base::Timers& timers);

/// Runs Study 1 for several friction coefficients. Solutions with one footprint share the skin
/// model; where a contact reaches the border of its footprint, it is solved again on a wider one.
/// Each solution is bit for bit the one that it would be without the other coefficients.
/// @param frictions coefficients of friction [1], in place of `input.contact.friction`
/// @returns one solution for each coefficient, in their order
std::vector<ContactSolution> solve_contact(const Case& input, const std::vector<double>& frictions,
                                           const ContactOptions& options, base::Timers& timers);

/// Runs Study 1 for several variants of a case, each with load steps of its own in place of
/// `options.steps`.
/// @returns one solution for each variant, in their order
std::vector<ContactSolution> solve_variants(const Case& input,
                                            const std::vector<ContactVariant>& variants,
                                            const ContactOptions& options, base::Timers& timers);

/// Solves steady sliding at given positions on the first slide. Each state is found without the
/// path that leads to it, so that it serves as a check of the path.
/// @param arc_lengths distances of the slider from the begin of the slide [m]
/// @returns one state for each distance, with its strain
std::vector<ContactState> solve_steady_sliding(const Case& input,
                                               const std::vector<double>& arc_lengths,
                                               const ContactOptions& options, base::Timers& timers);

} // namespace ionskin::mechanics
