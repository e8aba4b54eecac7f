// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/ion_transport.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/base/interrupt.hpp"
#include "ionskin/electrochemistry/solution_rows.hpp"
#include "ionskin/electrochemistry/time_grid.hpp"
#include "ionskin/electrochemistry/time_integrator.hpp"
#include "ionskin/electrochemistry/transport_grid.hpp"

#include <algorithm>
#include <utility>

namespace ionskin::electrochemistry {
namespace {

/// Below this many unknowns a second thread costs more than it gains.
constexpr std::size_t unknowns_per_thread = 4000;

int useful_threads(int threads, const ScaledGrid& grid) {
  const auto most = static_cast<int>(2 * grid.nodes() / unknowns_per_thread);
  return std::clamp(std::min(threads, most), 1, static_cast<int>(grid.levels));
}

/// The parts of one run, wired together.
class TransportRun {
public:
  TransportRun(const Case& input, const strain::StrainHistory& history, const IonOptions& options)
      : options_(options), grid_(make_transport_grid(input, history)),
        scales_(derive_scales(input.electrochemistry, history.core_thickness())),
        scaled_(scale_grid(grid_, scales_.debye_length)),
        times_(make_time_grid(history, step_rule(input.numerics, scales_), options.snapshot_times)),
        fixed_charge_(input, history, grid_, scaled_),
        team_(useful_threads(options.threads, scaled_)),
        solver_(scaled_, initial_ion_amount(scaled_), team_),
        integrator_(scaled_, scales_, fixed_charge_, options.potentials, solver_),
        rows_(input.electrochemistry, scales_, grid_, scaled_, fixed_charge_, times_,
              options.snapshot_times) {}

  IonSolution run() {
    begin();
    try {
      while (run_.step + 1 < times_.size()) {
        base::check_interrupt();
        advance();
      }
    } catch (const std::runtime_error&) {
      save();
      throw;
    }
    rows_.finish(run_.state.ions, run_.solution);
    return std::move(run_.solution);
  }

private:
  static double initial_ion_amount(const ScaledGrid& grid) {
    return ExactAverage::total(grid, std::vector<double>(grid.nodes(), 1.0));
  }

  void begin() {
    if (options_.resume) {
      resume();
    } else {
      integrator_.initialise(times_.front(), run_.state);
      run_.solution.grid = grid_;
      rows_.append(times_.front(), run_.state.ions, run_.solution);
      copy_counters();
    }
  }

  void resume() {
    run_ = *options_.resume;
    const auto& time = run_.solution.time;
    const bool same_grid = run_.solution.grid.x_edges == grid_.x_edges &&
                           run_.solution.grid.y_edges == grid_.y_edges &&
                           run_.solution.grid.z_nodes == grid_.z_nodes &&
                           run_.state.ions.nodes() == scaled_.nodes();
    if (!same_grid || time.size() != run_.step + 1 || time.size() > times_.size() ||
        !std::equal(time.begin(), time.end(), times_.begin())) {
      throw UserError(
          "the saved state of the ion transport belongs to another case: its grid or its "
          "time steps differ; remove it to start afresh");
    }
    solver_.restore_counters({run_.solution.newton_iterations, run_.solution.krylov_iterations,
                              run_.solution.preconditioner_setups});
    fixed_charge_.evaluate(times_[run_.step]);
  }

  void advance() {
    const double end = times_[run_.step + 1];
    integrator_.advance(times_[run_.step], end, run_.state);
    ++run_.step;
    rows_.append(end, run_.state.ions, run_.solution);
    copy_counters();
    options_.progress("ion transport",
                      static_cast<double>(run_.step) / static_cast<double>(times_.size() - 1));
    if (run_.step % options_.checkpoint_interval == 0) {
      save();
    }
  }

  void copy_counters() {
    run_.solution.steps = run_.step;
    run_.solution.newton_iterations = solver_.counters().newton_iterations;
    run_.solution.krylov_iterations = solver_.counters().krylov_iterations;
    run_.solution.preconditioner_setups = solver_.counters().preconditioner_setups;
  }

  void save() const {
    if (options_.checkpoint) {
      options_.checkpoint(run_);
    }
  }

  const IonOptions& options_;
  TransportGrid grid_;
  DerivedScales scales_;
  ScaledGrid scaled_;
  std::vector<double> times_;
  FixedCharge fixed_charge_;
  WorkerTeam team_;
  NewtonKrylov solver_;
  TimeIntegrator integrator_;
  SolutionRows rows_;
  IonCheckpoint run_;
};

} // namespace

IonSolution solve_ion_transport(const Case& input, const strain::StrainHistory& history,
                                const IonOptions& options, base::Timers& timers) {
  const base::Timers::Scope timer(timers, "electrochemistry");
  return TransportRun(input, history, options).run();
}

} // namespace ionskin::electrochemistry
