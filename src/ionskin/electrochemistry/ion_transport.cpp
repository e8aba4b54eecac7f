// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/ion_transport.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/base/system/interrupt.hpp"
#include "ionskin/electrochemistry/circuit/cut_electrode.hpp"
#include "ionskin/electrochemistry/circuit/external_circuit.hpp"
#include "ionskin/electrochemistry/circuit/sheet_electrodes.hpp"
#include "ionskin/electrochemistry/grid/mid_width_mirror.hpp"
#include "ionskin/electrochemistry/grid/transport_grid.hpp"
#include "ionskin/electrochemistry/taxel_crosstalk.hpp"
#include "ionskin/electrochemistry/thin_layers.hpp"
#include "ionskin/electrochemistry/time/circuit_charge.hpp"
#include "ionskin/electrochemistry/time/conductor_charges.hpp"
#include "ionskin/electrochemistry/time/sheet_charges.hpp"
#include "ionskin/electrochemistry/time/solution_rows.hpp"
#include "ionskin/electrochemistry/time/step_control.hpp"
#include "ionskin/electrochemistry/time/time_integrator.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <memory>
#include <utility>

namespace ionskin::electrochemistry {
namespace {

/// Number of unknowns below which a second thread costs more than it gains.
constexpr std::size_t unknowns_per_thread = 4000;

int useful_threads(int threads, const ScaledGrid& grid) {
  const auto most = static_cast<int>(2 * grid.nodes() / unknowns_per_thread);
  return std::clamp(std::min(threads, most), 1, static_cast<int>(grid.levels));
}

/// Tolerance of Newton's method: a share of the error allowed to a time step, within the limits of
/// rounding and of single precision in the preconditioner. With crowded ions the free share of the
/// sites, not the concentration, must be exact.
double newton_tolerance(double time_tolerance, IonModel model) {
  const double share = model == IonModel::steric ? 3e-3 : 0.3;
  return std::clamp(share * time_tolerance, 1e-9, 1e-4);
}

/// Least charge that the steps resolve, as a share of the charge that the largest coupling makes in
/// one Debye length: without it the steps would resolve a first contact however small its charge.
constexpr double least_charge = 1e-3;

/// Limit on residual evaluations plus Krylov iterations within a share `least_progress` of the
/// history. A step takes about ten of them, and about a hundred where columns differ much; so many
/// in so short a time lead nowhere.
constexpr std::size_t work_without_progress = 200'000;
constexpr double least_progress = 0.01;

/// True if the electrodes of one half of the skin about mid-width can stand for those of the other
/// half.
bool readout_is_mirrored(const Case& input) {
  if (input.has_sheet_resistance() && input.readout.contact == ElectrodeContact::corner) {
    return false;
  }
  return !input.readout.is_cut() || taxels_are_mirrored(input.readout, input.skin.width);
}

/// One run of Study 2, with all its parts.
class TransportRun {
public:
  TransportRun(const Case& input, const history::CoreHistory& history, const IonOptions& options)
      : options_(options), readout_(input.readout), grid_(make_transport_grid(input, history)),
        scales_(derive_scales(input.electrochemistry, history.core_thickness())),
        mirror_(grid_, history, readout_is_mirrored(input)),
        scaled_(scale_grid(mirror_.solved_grid(), scales_.debye_length, scales_.area_ratio)),
        control_(make_step_landings(
                     history, options.snapshot_times,
                     scan_switches(input.readout, history.time.front(), history.time.back())),
                 step_rule(input.numerics, input.readout, scales_)),
        fixed_charge_(input, history, mirror_.solved_grid(), scaled_),
        charge_floor_(least_charge * fixed_charge_.largest_coupling()),
        cut_(cut_electrode(input, scales_, grid_, mirror_)),
        sheets_(sheet_electrodes(input, scales_, mirror_, scaled_)),
        most_work_(options.most_work > 0 ? options.most_work : work_without_progress),
        team_(useful_threads(options.threads, scaled_)),
        solver_(scaled_, newton_tolerance(control_.tolerance(), input.electrochemistry.ion_model),
                team_, steric_excess(input.electrochemistry), conductors(), sheets()),
        electrodes_(electrode_charges(input)),
        integrator_(scaled_, scales_, fixed_charge_, options.potentials, *electrodes_, solver_,
                    team_),
        rows_(input, scales_, grid_, mirror_, scaled_, fixed_charge_, control_.landings().time,
              options.snapshot_times, cut_ ? &*cut_ : nullptr) {
    run_.solution.taxel_crosstalk = taxel_crosstalk(input, history);
  }

  IonSolution run() {
    begin();
    try {
      while (!control_.finished(time())) {
        base::check_interrupt();
        advance();
      }
    } catch (const std::runtime_error&) {
      save();
      throw;
    }
    save();
    rows_.finish(run_.state.ions, run_.solution);
    return std::move(run_.solution);
  }

private:
  double time() const { return run_.solution.time.back(); }
  /// Conductors of cut faces, as the solver needs them; nullptr where one potential for each face
  /// will do.
  const WallElectrodes* conductors() const {
    const bool opens = readout_.scan.dwell > 0 && !readout_.scan.grounds_others;
    return cut_ && (opens || !cut_->conductors.all_held()) ? &cut_->conductors : nullptr;
  }

  const SheetElectrodes* sheets() const { return sheets_ ? &*sheets_ : nullptr; }

  std::unique_ptr<ElectrodeCharges> electrode_charges(const Case& input) {
    if (conductors() != nullptr) {
      auto charges = std::make_unique<ConductorCharges>(scaled_, fixed_charge_, *conductors());
      conductor_charges_ = charges.get();
      return charges;
    }
    if (sheets_) {
      return std::make_unique<SheetCharges>(scaled_, fixed_charge_, *sheets_);
    }
    const auto admittance =
        cut_ ? std::nullopt
             : scaled_admittance(input.readout, scales_, input.skin.length * input.skin.width);
    if (admittance) {
      return std::make_unique<CircuitCharge>(scaled_, fixed_charge_, *admittance);
    }
    return std::make_unique<ElectrodeCharges>(scaled_, fixed_charge_);
  }

  void begin() {
    if (options_.resume) {
      resume();
    } else {
      const double begin = control_.landings().time.front();
      read_row_at(begin);
      integrator_.initialise(begin, run_.state);
      run_.state.next_step = control_.first_step();
      run_.state.charge_scale = std::max(run_.state.charge_scale, charge_floor_);
      run_.solution.grid = grid_;
      append_row(begin);
      copy_counters();
    }
    note_progress();
  }

  void resume() {
    const std::optional<double> crosstalk = run_.solution.taxel_crosstalk;
    run_ = *options_.resume;
    run_.solution.taxel_crosstalk = crosstalk;
    const std::vector<double>& done = run_.solution.time;
    const bool same_grid = run_.solution.grid.x_edges == grid_.x_edges &&
                           run_.solution.grid.y_edges == grid_.y_edges &&
                           run_.solution.grid.z_nodes == grid_.z_nodes &&
                           run_.state.ions.nodes() == scaled_.nodes() &&
                           run_.state.electrode_charge.size() == electrodes_->size();
    if (!same_grid || done.size() != run_.step + 1 || !control_.has_landed(done)) {
      throw UserError(
          "the saved state of the ion transport belongs to another case: its grid or its "
          "time steps differ; remove it to start afresh");
    }
    solver_.restore_counters({run_.solution.residual_evaluations, run_.solution.krylov_iterations,
                              run_.solution.preconditioner_setups});
    read_row_at(time());
    integrator_.take_up(time(), run_.state);
  }

  void advance() {
    const double begin = time();
    const double end = take_step(begin);
    ++run_.step;
    append_row(end);
    read_next_row(end);
    copy_counters();
    const auto [from, to] = control_.span();
    if (end - noted_time_ > least_progress * (to - from)) {
      note_progress();
    }
    options_.progress("ion transport", (end - from) / (to - from));
    if (run_.step % options_.checkpoint_interval == 0 &&
        base::wall_time() - saved_at_ >= options_.checkpoint_seconds) {
      save();
      saved_at_ = base::wall_time();
    }
  }

  /// Row that a scan reads from an instant on [s]; nothing without a scan.
  std::optional<std::size_t> row_at(double time) const {
    return cut_ && readout_.scan.dwell > 0
               ? std::optional(readout_.row_read_at(time - control_.landings().time.front()))
               : std::nullopt;
  }

  void read_row_at(double time) {
    row_ = row_at(time);
    if (row_ && conductor_charges_ != nullptr) {
      conductor_charges_->connect(cut_->circuits(readout_.scan, *row_));
    }
  }

  void read_next_row(double time) {
    const std::optional<std::size_t> next = row_at(time);
    if (next == row_ || control_.finished(time)) {
      return;
    }
    row_ = next;
    if (conductor_charges_ != nullptr) {
      conductor_charges_->reconnect(cut_->circuits(readout_.scan, *row_), run_.state);
      integrator_.restart(time, run_.state);
    }
  }

  /// Tries shorter and shorter steps until one is accurate enough; returns its end [s].
  double take_step(double begin) {
    TransportState& state = run_.state;
    while (true) {
      base::check_interrupt();
      const double end = control_.step_end(begin, state.next_step);
      if (work() - noted_work_ > most_work_) {
        end_without_progress(begin, end);
      }
      const std::optional<double> error =
          integrator_.try_step(begin, end, state, control_.column_share(begin));
      const double share = error.value_or(0.0) / control_.tolerance();
      if (error && share <= 1.0) {
        integrator_.accept(state);
        state.next_step = control_.after_success(begin, end, state.next_step, share);
        return end;
      }
      ++run_.solution.rejected_steps;
      state.next_step =
          error ? control_.after_rejection(begin, end, share) : control_.after_failure(begin, end);
      if (control_.too_short(state.next_step)) {
        give_up(begin, end);
      }
    }
  }

  void note_progress() {
    noted_time_ = time();
    noted_work_ = work();
  }

  std::size_t work() const {
    return solver_.counters().residual_evaluations + solver_.counters().krylov_iterations;
  }

  [[noreturn]] void end_without_progress(double begin, double end) const {
    throw SolverError(
        fmt::format("the ion transport makes no progress: {} steps and {} failed attempts reached "
                    "t = {:.9g} "
                    "s of {:.9g} s, and the next step is of {:.2g} s; potentials reach {:.3g} V",
                    run_.step, run_.solution.rejected_steps, begin, control_.span().second,
                    end - begin, scales_.potential_scale * largest_potential()),
        fmt::format(
            "make coupling.coefficient smaller or the motion slower: charge that comes "
            "faster than ions can follow makes such potentials{}; --resume continues as it is",
            solver_.excess() ? "; or raise electrochemistry.largest_concentration, or set "
                               "electrochemistry.ion_model = \"dilute\""
                             : ""));
  }

  double largest_potential() const {
    const auto potential = run_.state.ions.potential();
    const auto [least, most] = std::ranges::minmax(potential);
    return std::max(std::abs(least), std::abs(most));
  }

  [[noreturn]] void give_up(double begin, double end) const {
    throw SolverError(
        fmt::format("the ion transport found no solution between t = {:.9g} s and {:.9g} s; before "
                    "that the smallest concentration was {:.3g} of its initial value",
                    begin, end, std::ranges::min(run_.state.ions.concentration())),
        std::string("raise numerics.mesh_refinement, or make coupling.coefficient or the electrode "
                    "potentials smaller") +
            (solver_.excess() ? ", or electrochemistry.largest_concentration larger" : ""));
  }

  void append_row(double time) {
    rows_.append(time, run_.state.ions, integrator_.reading(run_.state), row_, run_.solution);
  }

  void copy_counters() {
    run_.solution.steps = run_.step;
    run_.solution.residual_evaluations = solver_.counters().residual_evaluations;
    run_.solution.krylov_iterations = solver_.counters().krylov_iterations;
    run_.solution.preconditioner_setups = solver_.counters().preconditioner_setups;
  }

  void save() const {
    if (options_.checkpoint) {
      options_.checkpoint(run_);
    }
  }

  const IonOptions& options_;
  Readout readout_;
  std::optional<std::size_t> row_; ///< row that the scan reads; nothing without a scan
  TransportGrid grid_;
  DerivedScales scales_;
  MidWidthMirror mirror_;
  ScaledGrid scaled_;
  StepControl control_;
  FixedCharge fixed_charge_;
  double charge_floor_;
  std::optional<CutElectrode> cut_;
  std::optional<SheetElectrodes> sheets_;
  std::size_t most_work_, noted_work_ = 0;
  double noted_time_ = 0; ///< [s]
  parallel::WorkerTeam team_;
  NewtonKrylov solver_;
  ConductorCharges* conductor_charges_ = nullptr; ///< `electrodes_` of cut faces; else nullptr
  std::unique_ptr<ElectrodeCharges> electrodes_;
  TimeIntegrator integrator_;
  SolutionRows rows_;
  IonCheckpoint run_;
  /// Wall time of the last checkpoint, at first of the begin [s].
  double saved_at_ = base::wall_time();
};

} // namespace

IonSolution solve_ion_transport(const Case& input, const history::CoreHistory& history,
                                const IonOptions& options, base::Timers& timers) {
  const base::Timers::Scope timer(timers, "electrochemistry");
  return input.electrochemistry.ion_model == IonModel::thin_layers
             ? solve_thin_layers(input, history, options)
             : TransportRun(input, history, options).run();
}

} // namespace ionskin::electrochemistry
