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

/// Options of Study 1.
struct ContactOptions {
  int threads = 1;
  /// Threads that make the skin, for which all solutions on it wait, and that recover strains after
  /// all are solved; 0: the same.
  int shared_threads = 0;
  /// Null, or where threads come from that help to recover strains while others solve.
  std::shared_ptr<parallel::SpareThreads> spare;
  base::ProgressCallback progress = base::no_progress; ///< called from one thread at a time
  PathSteps steps;
  /// Footprint as `find_footprint` found it for these loads and this friction; empty to find it.
  std::optional<mesh::Footprint> footprint;
  /// Meshes the whole skin where half of it would do, to compare.
  bool full_model = false;
  /// Null, or given the path as far as it went where the solver gives up, before the SolverError.
  std::function<void(const ContactSolution&)> unfinished;
};

/// Values that may differ between solutions that share the skin.
struct ContactVariant {
  double friction = 0;
  PathSteps steps;
  /// Null, or paths of other sliders that press the same skin at the same time.
  std::shared_ptr<const std::vector<ForcePath>> others = {};
};

/// All of Study 1. Throws SolverError when contact does not converge, Interrupted on request.
ContactSolution solve_contact(const Case& input, const ContactOptions& options,
                              base::Timers& timers);

/// All of Study 1 for several friction coefficients, of which those with one footprint share the
/// skin; a contact that reaches its border is solved on a wider one by itself. Each
/// solution is the same bits as alone. One solution each, in order; `input.contact.friction` is not
/// used.
std::vector<ContactSolution> solve_contact(const Case& input, const std::vector<double>& frictions,
                                           const ContactOptions& options, base::Timers& timers);

/// All of Study 1 for variants of a case, each with load steps of its own; `options.steps` is not
/// used.
std::vector<ContactSolution> solve_variants(const Case& input,
                                            const std::vector<ContactVariant>& variants,
                                            const ContactOptions& options, base::Timers& timers);

/// Steady sliding at any arc lengths of the first slide [m], each found by itself:
/// nothing of it comes from the path, so that checks compare with it.
std::vector<ContactState> solve_steady_sliding(const Case& input,
                                               const std::vector<double>& arc_lengths,
                                               const ContactOptions& options, base::Timers& timers);

} // namespace ionskin::mechanics
