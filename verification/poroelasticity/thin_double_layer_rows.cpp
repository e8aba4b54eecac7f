// SPDX-License-Identifier: Apache-2.0
#include "electrochemistry/model_run.hpp"
#include "poroelasticity/rows.hpp"
#include "poroelasticity/wet_cell.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <memory>
#include <string>
#include <vector>

namespace ionskin::verification {
namespace {

using electrochemistry::IonSolution;

constexpr double length = 6e-3; // [m]
constexpr std::size_t cells_along = 48;

/// Strain history of a bump of pressure that presses more on one wall: it comes, moves along the
/// skin and goes.
history::CoreHistory stroke(double duration) {
  constexpr std::size_t samples = 40;
  std::vector<double> time;
  for (std::size_t i = 0; i <= samples; ++i) {
    time.push_back(duration * static_cast<double>(i) / samples);
  }
  history::CoreHistory all = held_pressure_history(
      length, cells_along, [](double, double) { return 0.0; }, time);
  history::HistoryChannel& channel = all.channels.front();
  for (std::size_t i = 0; i <= samples; ++i) {
    const double part = static_cast<double>(i) / samples;
    const double load = small_pressure * std::clamp(4 * std::min(part, 1 - part), 0.0, 1.0);
    const double place = length * (0.3 + 0.4 * part);
    const auto bump = [=](double x, double height) {
      const double distance = (x - place) / 0.5e-3;
      return load * std::exp(-distance * distance) * (1 + 0.3 * (height - 0.5));
    };
    channel.samples[i] =
        held_pressure_history(length, cells_along, bump, {0.0}).channels.front().samples.front();
  }
  return all;
}

struct Agreement {
  double charge = 0; ///< largest difference of the charge over the largest charge
  /// Ratio of the largest current between samples, thin layers over full equations.
  double peak = 0;
};

Agreement agreement(Case input, double duration, const Options& options) {
  input.skin.length = length;
  const history::CoreHistory history = stroke(duration);
  const IonSolution full = run_model(input, history, options);
  input.electrochemistry.ion_model = IonModel::thin_layers;
  const IonSolution thin = run_model(input, history, options);
  double difference = 0, largest = 0;
  std::array<double, 2> before{}, peak{};
  for (const double time : history.time) {
    const std::array<double, 2> charge{charge_difference(full, row_at(full, time)),
                                       charge_difference(thin, row_at(thin, time))};
    difference = std::max(difference, std::abs(charge[1] - charge[0]));
    largest = std::max(largest, std::abs(charge[0]));
    for (std::size_t k = 0; k < 2; ++k) {
      peak[k] = std::max(peak[k], std::abs(charge[k] - before[k]));
    }
    before = charge;
  }
  return {difference / largest, peak[1] / peak[0]};
}

} // namespace

std::vector<Row> thin_double_layer_rows(const Options& options) {
  std::vector<Row> rows;
  const auto add = [&](const std::string& name, const Case& input, double duration) {
    const Agreement found = agreement(input, duration, options);
    rows.push_back(
        compare("P10", "thin layers: charge against the full equations, over the largest, " + name,
                found.charge, 0, 0.01));
    rows.push_back(compare("P10",
                           "thin layers: peak current over that of the full equations, " + name,
                           found.peak, 1, 0.01));
  };
  add("slow water", wet_case(), 4.0);
  add("wet protons", proton_case(), 4.0);
  return rows;
}

} // namespace ionskin::verification
