// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/base/progress.hpp"
#include "ionskin/base/timers.hpp"
#include "ionskin/case/case.hpp"
#include "ionskin/electrochemistry/output/electrode_potentials.hpp"
#include "ionskin/electrochemistry/output/ion_solution.hpp"
#include "ionskin/electrochemistry/output/ion_state.hpp"
#include "ionskin/history/core_history.hpp"

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace ionskin::electrochemistry {

/// State of a run of Study 2 at the end of a time step, from which it resumes with the same result
/// bit for bit.
struct IonCheckpoint {
  std::size_t step = 0; ///< number of accepted steps
  /// Solver state in scaled units.
  TransportState state;
  IonSolution solution; ///< all rows and snapshots so far
};

/// Options of a run of Study 2. Threads, progress and checkpoints do not change the result.
struct IonOptions {
  int threads = 1;
  base::ProgressCallback progress = base::no_progress;
  ElectrodePotentials potentials; ///< by default 0 V at both electrodes
  /// Instants at which snapshots of the fields are stored [s]; a time step ends on each.
  std::vector<double> snapshot_times;
  /// Callback that stores the state of the run; empty for none. It is called every
  /// `checkpoint_interval` steps, though not sooner than `checkpoint_seconds` of wall time after
  /// the last call, before an interruption or a SolverError leaves the solver, and at the end.
  std::function<void(const IonCheckpoint&)> checkpoint;
  std::size_t checkpoint_interval = 50;
  double checkpoint_seconds = 5;
  /// Checkpoint from which the run resumes; nothing for a new run. UserError is thrown when it
  /// belongs to another grid or to other time steps.
  std::optional<IonCheckpoint> resume;
  /// Limit on residual evaluations plus Krylov iterations within a hundredth of the history, beyond
  /// which the run is given up with a SolverError; 0 for many times the work that any known case
  /// takes.
  std::size_t most_work = 0;
};

/// Solves the ion transport in the core under a strain history and returns one row per time step.
/// Ion model `thin-layers` is solved by `solve_thin_layers`. Adds its time to the stage
/// "electrochemistry" of `timers`.
/// Throws Interrupted, UserError when `options.resume` does not fit, and SolverError when the fixed
/// charge becomes negative, a step finds no solution, or the steps make no progress.
/// @param history strain history, with a channel that drives the coupling law of the case
IonSolution solve_ion_transport(const Case& input, const history::CoreHistory& history,
                                const IonOptions& options, base::Timers& timers);

} // namespace ionskin::electrochemistry
