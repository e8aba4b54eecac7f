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

/// All that a run needs to go on where it stopped, with the same result bit for bit.
struct IonCheckpoint {
  std::size_t step = 0; ///< finished steps; the rejected ones do not count
  TransportState state; ///< scaled
  IonSolution solution; ///< all rows and snapshots so far
};

/// Options of Study 2; no option changes its numbers.
struct IonOptions {
  int threads = 1;
  base::ProgressCallback progress = base::no_progress;
  ElectrodePotentials potentials;
  /// Instants at which snapshots are kept [s]; steps land on them.
  std::vector<double> snapshot_times;
  /// Receives the run's state every `checkpoint_interval` steps, though not sooner than
  /// `checkpoint_seconds` of wall time after the last, before an interruption or a SolverError
  /// leaves the solver, and at the end.
  std::function<void(const IonCheckpoint&)> checkpoint;
  std::size_t checkpoint_interval = 50;
  double checkpoint_seconds = 5;
  /// Continues from here. UserError when it belongs to another grid or other time steps.
  std::optional<IonCheckpoint> resume;
  /// Residuals and Krylov iterations within a hundredth of the history after which a run is given
  /// up; 0 for many times what any case is known to take.
  std::size_t most_work = 0;
};

/// Solves ion transport in the core for a history of shear and returns one row per time step.
/// Stage in `timers`: "electrochemistry". Throws Interrupted, and SolverError when the fixed charge
/// becomes negative, a step finds no solution, or steps get nowhere.
IonSolution solve_ion_transport(const Case& input, const history::CoreHistory& history,
                                const IonOptions& options, base::Timers& timers);

} // namespace ionskin::electrochemistry
