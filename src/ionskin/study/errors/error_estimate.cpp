// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/errors/error_estimate.hpp"

#include "ionskin/base/largest.hpp"
#include "ionskin/case/coupling.hpp"
#include "ionskin/circuits/circuit.hpp"
#include "ionskin/electrochemistry/coupling/driving_channel.hpp"
#include "ionskin/electrochemistry/grid/derived_scales.hpp"
#include "ionskin/electrochemistry/ion_transport.hpp"
#include "ionskin/electrochemistry/thin_layers.hpp"
#include "ionskin/history/merged_cells.hpp"
#include "ionskin/history/shear_statistics.hpp"
#include "ionskin/mechanics/coarser_solutions.hpp"
#include "ionskin/parallel/shared_progress.hpp"
#include "ionskin/parallel/task_pool.hpp"
#include "ionskin/poroelasticity/validity.hpp"
#include "ionskin/readout/slider_suffix.hpp"
#include "ionskin/readout/tail_current.hpp"
#include "ionskin/study/errors/convergence.hpp"
#include "ionskin/study/errors/signal_difference.hpp"
#include "ionskin/study/metrics/charge_rounding.hpp"
#include "ionskin/study/metrics/slip_metrics.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace ionskin::study {
namespace {

namespace parts = error_parts;

// Names of runs of Study 2. Runs driven by coarser solutions of Study 1 have the names of these.
constexpr const char* own_run = "run";
constexpr const char* grid_run = "grid"; ///< run with twice the mesh sizes of Study 2
/// Run with twice the mesh sizes of Study 2 and up to twice its time steps.
constexpr const char* reference_run = "reference";
/// Run as `reference_run`, with the strain history on cells twice as wide.
constexpr const char* cells_run = "cells";

MechanicsRecord on_wider_cells(const MechanicsRecord& mechanics) {
  MechanicsRecord result = mechanics;
  result.maps = {};
  for (SliderRecord& further : result.further_sliders) {
    further.maps = {};
  }
  result.coarser_solutions.clear();
  result.history = history::merge_cells(mechanics.history);
  return result;
}

bool has_coarser_solutions(const MechanicsRecord& mechanics) {
  return mechanics.coarser_solutions.contains(mechanics::coarser_solutions::mesh);
}

double path_floor(const MechanicsRecord& mechanics) {
  double worst = mechanics.worst_equilibrium_residual + mechanics.worst_complementarity_residual;
  for (const SliderRecord& further : mechanics.further_sliders) {
    worst = base::nan_max(worst, further.worst_equilibrium_residual +
                                     further.worst_complementarity_residual);
  }
  return worst;
}

/// Least errors, by metric, that contact cells and steps of the path leave even where two solutions
/// happen to agree.
std::vector<readout::Metric> least_errors(const Case& input, const MechanicsRecord& mechanics) {
  std::vector<readout::Metric> errors = mechanics.cell_errors;
  for (std::size_t i = 0; i < mechanics.further_sliders.size(); ++i) {
    for (const readout::Metric& error : mechanics.further_sliders[i].cell_errors) {
      errors.push_back({error.name + readout::slider_suffix(i + 1), error.value, error.unit});
    }
  }
  const auto of_slip = slip_least_errors(input, mechanics);
  errors.insert(errors.end(), of_slip.begin(), of_slip.end());
  return errors;
}

double decoupling(const Case& input) {
  return moves_water(input) ? poroelasticity::decoupling_error(input) : 0.0;
}

/// Relative error of the limit of thin double layers, to first order in their thickness and in the
/// drive [1]; 0 under other ion models.
double thin_layers(const Case& input, double core_thickness,
                   const electrochemistry::WaterRows& water) {
  if (input.electrochemistry.ion_model != IonModel::thin_layers) {
    return 0.0;
  }
  const double drive =
      std::accumulate(water.largest_drive.begin(), water.largest_drive.end(), 0.0, base::nan_max);
  return electrochemistry::thin_layer_error(input.electrochemistry, core_thickness) + drive;
}

/// One coarser run of Study 2, with the mechanics that drives it.
struct Coarser {
  std::string name;
  const MechanicsRecord* mechanics = nullptr;
  double time_refinement = 0.5;
};

/// The case without the noise of its instruments, which is not an error of the program.
Case without_noise(const Case& input) {
  Case result = input;
  for (const circuits::CircuitRow& circuit : circuits::circuits()) {
    const auto silence = [&](laws::LawValues& values) {
      const auto known = values.find(circuit.noise);
      if (!circuit.noise.empty() && known != values.end()) {
        known->second = 0.0;
      }
    };
    silence(result.readout.parameters);
    for (Taxel& taxel : result.readout.taxels) {
      silence(taxel.parameters);
    }
  }
  return result;
}

/// True if an instrument reads an electrode or a taxel.
bool has_instrument(const Readout& readout) {
  bool found = bool(circuits::circuit(readout.circuit, readout.parameters).read);
  for (std::size_t i = 0; i < readout.taxels.size() && !found; ++i) {
    found = bool(circuits::circuit(readout.circuit_of(i), readout.parameters_of(i)).read);
  }
  return found;
}

/// Coarser runs of Study 2 from which the parts of the error of a run are estimated.
struct CoarserRuns {
  /// Mechanics of `cells_run`; the other runs use the run's own mechanics or its coarser solutions.
  MechanicsRecord wider;
  std::vector<Coarser> runs;

  explicit CoarserRuns(const MechanicsRecord& mechanics)
      : runs{{grid_run, &mechanics, 1.0}, {reference_run, &mechanics, 0.5}} {
    if (mechanics.has_contact()) {
      wider = on_wider_cells(mechanics);
      runs.push_back({cells_run, &wider});
      for (const auto& [name, coarser] : mechanics.coarser_solutions) {
        runs.push_back({name, coarser.get()});
      }
    }
  }
  CoarserRuns(const CoarserRuns&) = delete;
  CoarserRuns& operator=(const CoarserRuns&) = delete;
};

/// Solves each coarser run of Study 2, in parallel, and returns by name what `of_run(case,
/// mechanics, ions)` makes of it.
template <class Result, class OfRun>
std::map<std::string, Result> run_coarser(const Case& input, const std::vector<Coarser>& runs,
                                          int threads, const base::ProgressCallback& progress,
                                          const OfRun& of_run) {
  std::vector<Result> results(runs.size());
  parallel::SharedProgress shared("error estimate", progress);
  shared.begin_pass(runs.size(), 1);
  parallel::run_tasks(runs.size(), threads, [&](std::size_t i) {
    Case coarser = input;
    coarser.numerics.mesh_refinement *= 0.5;
    coarser.numerics.time_refinement *= runs[i].time_refinement;
    base::Timers own;
    results[i] =
        of_run(coarser, *runs[i].mechanics,
               electrochemistry::solve_ion_transport(coarser, runs[i].mechanics->history, {}, own));
    shared.finish_unit();
  });
  std::map<std::string, Result> by_name;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    by_name.emplace(runs[i].name, std::move(results[i]));
  }
  return by_name;
}

struct NamedPair {
  const char* part;
  const char* finer;
  const char* coarser;
};

/// Pairs of runs, by name, whose differences give the parts of the error that Study 1 makes.
std::vector<NamedPair> mechanics_pairs(const MechanicsRecord& mechanics) {
  if (!mechanics.has_contact()) {
    return {};
  }
  std::vector<NamedPair> pairs{
      {parts::mechanics_mesh, reference_run, mechanics::coarser_solutions::mesh},
      {parts::path, mechanics::coarser_solutions::mesh, mechanics::coarser_solutions::path},
      {parts::handover, reference_run, cells_run}};
  if (mechanics.coarser_solutions.contains(mechanics::coarser_solutions::thickness)) {
    pairs.push_back({parts::mechanics_mesh, mechanics::coarser_solutions::thickness,
                     mechanics::coarser_solutions::mesh});
  }
  return pairs;
}

/// Pairs of runs, by name, for all parts of the error. `own_run` is the run itself.
std::vector<NamedPair> all_pairs(const MechanicsRecord& mechanics) {
  std::vector<NamedPair> pairs = mechanics_pairs(mechanics);
  pairs.push_back({parts::transport_grid, own_run, grid_run});
  pairs.push_back({parts::time_steps, grid_run, reference_run});
  return pairs;
}

std::vector<ErrorPair> pairs_of(const std::vector<NamedPair>& names,
                                const std::map<std::string, Signals>& results) {
  std::vector<ErrorPair> pairs;
  for (const NamedPair& pair : names) {
    pairs.push_back({pair.part, &results.at(pair.finer), &results.at(pair.coarser)});
  }
  return pairs;
}

/// Reason for no error estimate at all: a part of the error would not stand for the whole.
constexpr const char* no_coarser_solutions = "Study 1 has no solution on a coarser mesh";

} // namespace

ErrorEstimate no_estimate(const Signals& signals, const std::string& reason) {
  ErrorEstimate estimate;
  for (const readout::Metric& metric : signals.metrics) {
    estimate.not_estimated[metric.name] = reason;
  }
  return estimate;
}

ErrorEstimate estimate_errors(const Case& input, const MechanicsRecord& mechanics,
                              const electrochemistry::IonSolution& ions, const Signals& signals,
                              int threads, base::Timers& timers,
                              const base::ProgressCallback& progress) {
  const base::Timers::Scope timer(timers, "error estimate");
  if (mechanics.has_contact() && !has_coarser_solutions(mechanics)) {
    return no_estimate(signals, no_coarser_solutions);
  }
  const Case quiet = without_noise(input);
  const CoarserRuns coarser(mechanics);
  auto results = run_coarser<Signals>(
      quiet, coarser.runs, threads, progress,
      [](const Case& own, const MechanicsRecord& record, const electrochemistry::IonSolution& its) {
        return read_out(own, record, its, 1);
      });
  const bool noisy = has_instrument(input.readout);
  const Signals& base =
      results.emplace(own_run, noisy ? read_out(quiet, mechanics, ions, threads) : signals)
          .first->second;
  const ErrorFloors floors{
      path_floor(mechanics),
      decoupling(input),
      thin_layers(input, mechanics.history.core_thickness(), ions.water),
      charge_rounding(input, mechanics.history),
      input.readout.sample_interval,
      least_errors(input, mechanics),
      readout::in_tail(base.sampled, input.readout.sample_interval, mechanics.history.event_time,
                       electrochemistry::derive_scales(input.electrochemistry,
                                                       mechanics.history.core_thickness())
                           .relaxation_time),
      imposed_errors(input, base)};
  ErrorEstimate estimate = combine_errors(base, pairs_of(all_pairs(mechanics), results), floors);
  estimate.not_converging = not_converging(mechanics, signals, estimate.relative);
  return estimate;
}

std::vector<double> estimate_data_errors(const Case& input, const MechanicsRecord& mechanics,
                                         const electrochemistry::IonSolution& ions,
                                         const FitData& data, int threads) {
  if (mechanics.has_contact() && !has_coarser_solutions(mechanics)) {
    return {};
  }
  const CoarserRuns coarser(mechanics);
  auto results = run_coarser<std::vector<double>>(
      input, coarser.runs, threads, base::no_progress,
      [&data](const Case&, const MechanicsRecord&, const electrochemistry::IonSolution& its) {
        return predict(data, its);
      });
  results.emplace(own_run, predict(data, ions));
  readout::SignalTable base;
  base.columns = {{"time", "s", data.time}, {data.column, data.unit, results.at(own_run)}};
  const auto table = [&](const char* name) {
    readout::SignalTable other = base;
    other.columns.back().values = results.at(name);
    return other;
  };
  ErrorFloors floors;
  floors.decoupling = decoupling(input);
  floors.thin_layers = thin_layers(input, mechanics.history.core_thickness(), ions.water);
  const double relative = relative_floor(floors, data.column, data.unit);
  std::vector<double> errors;
  for (const double value : base.columns.back().values) {
    errors.push_back(relative * std::abs(value));
  }
  for (const NamedPair& pair : all_pairs(mechanics)) {
    const auto band = pair_band(base.columns.back().values, pair.part,
                                table_difference(base, table(pair.finer), table(pair.coarser)),
                                data.column, path_floor(mechanics));
    for (std::size_t row = 0; row < errors.size(); ++row) {
      errors[row] += band[row];
    }
  }
  return errors;
}

ErrorEstimate estimate_mechanics_errors(const Case& input, const MechanicsRecord& mechanics,
                                        const Signals& signals, int threads) {
  if (!has_coarser_solutions(mechanics)) {
    return no_estimate(signals, no_coarser_solutions);
  }
  std::map<std::string, Signals> results{
      {reference_run, signals},
      {cells_run, read_out_mechanics(input, on_wider_cells(mechanics), threads)}};
  for (const auto& [name, coarser] : mechanics.coarser_solutions) {
    results.emplace(name, read_out_mechanics(input, *coarser, threads));
  }
  ErrorEstimate estimate = combine_errors(signals, pairs_of(mechanics_pairs(mechanics), results),
                                          {.path = path_floor(mechanics),
                                           .cells = least_errors(input, mechanics),
                                           .imposed = imposed_errors(input, signals)});
  estimate.not_converging = not_converging(mechanics, signals, estimate.relative);
  return estimate;
}

} // namespace ionskin::study
