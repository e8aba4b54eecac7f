// SPDX-License-Identifier: Apache-2.0
#include "electrochemistry/model_cases.hpp"
#include "electrochemistry/model_run.hpp"
#include "electrochemistry/rows.hpp"
#include "ionskin/history/strain_projection.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

namespace ionskin::verification {
namespace {

using electrochemistry::IonSolution;

/// Averages a strain history along x and y: one column at rest with the same samples.
history::CoreHistory laterally_averaged(const history::CoreHistory& history) {
  history::CoreHistory average = linear_step_history(0.0, 0.0, history.time);
  average.grid.z_nodes = history.grid.z_nodes;
  average.event_time = history.event_time;
  const std::size_t cells = history.grid.columns_x() * history.grid.columns_y();
  for (std::size_t sample = 0; sample < history.time.size(); ++sample) {
    history::StrainField means;
    for (std::size_t k = 0; k < history.grid.z_nodes.size(); ++k) {
      double sum = 0.0;
      for (std::size_t i = 0; i < cells; ++i) {
        sum += (*history.shear()[sample])[k * cells + i];
      }
      // The grid rides with the slider and is longer than the core; the shear is inside the core.
      const double grid_length = history.grid.x_edges.back() - history.grid.x_edges.front();
      means.push_back(sum / static_cast<double>(cells) * grid_length / history.length);
    }
    average.shear()[sample] = std::make_shared<const history::StrainField>(means);
  }
  return average;
}

/// Largest deviation between the difference charges of two runs at given instants, relative.
double deviation(const IonSolution& a, const IonSolution& b, const std::vector<double>& instants) {
  double error = 0.0, scale = 0.0;
  for (const double time : instants) {
    const double other = charge_difference(b, row_at(b, time));
    error = std::max(error, std::abs(charge_difference(a, row_at(a, time)) - other));
    scale = std::max(scale, std::abs(other));
  }
  return error / scale;
}

double deviation_from_average(const std::string& law, double coefficient, const Options& options) {
  Case input = model_case();
  input.numerics.preset = Preset::coarse;
  input.coupling.law = law;
  input.coupling.coefficient = coefficient;
  const history::CoreHistory history = sliding_contact_history(1);
  return deviation(run_model(input, history, options),
                   run_model(input, laterally_averaged(history), options), history.time);
}

} // namespace

std::vector<Row> lateral_average_rows(const Options& options) {
  return {at_most("E8", "deviation from the averaged shear's response at k = 0.0001",
                  deviation_from_average("fixed-charge", 1e-4, options), 1e-3),
          at_most("E8", "the same under column-neutral at k = 0.001",
                  deviation_from_average("column-neutral", 1e-3, options), 1e-3),
          compare("E8", "the same under fixed-charge at k = 0.1: nonlinear",
                  deviation_from_average("fixed-charge", 0.1, options), 0.09, 0.02)};
}

} // namespace ionskin::verification
