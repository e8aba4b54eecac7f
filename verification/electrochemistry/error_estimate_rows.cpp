// SPDX-License-Identifier: Apache-2.0
#include "electrochemistry/model_cases.hpp"
#include "electrochemistry/model_run.hpp"
#include "electrochemistry/rows.hpp"

#include "ionskin/electrochemistry/grid/derived_scales.hpp"
#include "ionskin/readout/sampling.hpp"
#include "ionskin/readout/tail_current.hpp"
#include "ionskin/study/errors/error_estimate.hpp"

#include <cstddef>
#include <memory>
#include <string>
#include <utility>

namespace ionskin::verification {
namespace {

using electrochemistry::IonSolution;

/// Strain history of one sliding cycle averaged over the width: two-dimensional, so that a far
/// finer reference is affordable.
history::CoreHistory plane_history() {
  history::CoreHistory history = sliding_contact_history(1);
  const std::size_t rows = history.grid.columns_y(), columns = history.grid.columns_x();
  for (auto& sample : history.shear()) {
    history::StrainField mean(columns * history.grid.z_nodes.size(), 0.0);
    for (std::size_t i = 0; i < sample->size(); ++i) {
      const std::size_t level = i / (rows * columns);
      mean[level * columns + i % columns] += (*sample)[i] / static_cast<double>(rows);
    }
    sample = std::make_shared<const history::StrainField>(std::move(mean));
  }
  history.grid.y_edges = {history.grid.y_edges.front(), history.grid.y_edges.back()};
  return history;
}

readout::SignalTable sampled_currents(const Case& input, const IonSolution& solution) {
  readout::SignalTable table;
  table.columns = {{"time", "s", solution.time},
                   {"charge_top", "C", solution.charge_top},
                   {"charge_bottom", "C", solution.charge_bottom}};
  return readout::sample_currents(table, input.readout.sample_interval,
                                  {solution.relaxation_charge, solution.relaxation_current});
}

/// Relative error of the tail of the difference current, extrapolated from a run on half the mesh
/// sizes and half the time steps.
double true_tail_error(const Case& input, const history::CoreHistory& history,
                       const IonSolution& solution, const Options& options) {
  Case refined = input;
  refined.numerics.mesh_refinement *= 2.0;
  refined.numerics.time_refinement *= 2.0;
  const readout::SignalTable coarse = sampled_currents(input, solution);
  const readout::SignalTable fine = sampled_currents(input, run_model(refined, history, options));
  const auto& current = fine.column("current_difference").values;
  std::vector<double> difference = coarse.column("current_difference").values;
  for (std::size_t i = 0; i < difference.size(); ++i) {
    difference[i] -= current[i];
  }
  const std::vector<bool> tail = readout::in_tail(
      coarse, input.readout.sample_interval, history.event_time,
      electrochemistry::derive_scales(input.electrochemistry, history.core_thickness())
          .relaxation_time);
  return 4.0 / 3.0 * readout::tail_rms(difference, tail) / readout::tail_rms(current, tail);
}

} // namespace

std::vector<Row> error_estimate_rows(const Options& options) {
  const history::CoreHistory history = plane_history();
  std::vector<Row> rows;
  for (const std::string law : {"fixed-charge", "column-neutral"}) {
    Case input = model_case();
    input.numerics.preset = Preset::coarse;
    input.coupling.law = law;
    const IonSolution solution = run_model(input, history, options);
    base::Timers timers;
    study::MechanicsRecord given;
    given.history = history;
    const auto estimate = study::estimate_errors(
        input, given, solution, study::read_out(input, given, solution, options.threads),
        options.threads, timers);
    // The ratio must lie between 1 and 5.
    rows.push_back(compare("C5", law + ": estimated over true error of the tail current",
                           estimate.relative.at("tail_current_difference") /
                               true_tail_error(input, history, solution, options),
                           3.0, 2.0));
  }
  return rows;
}

} // namespace ionskin::verification
