// SPDX-License-Identifier: Apache-2.0
#include "ionskin/results/strain_file/strain_events.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace ionskin::results {
namespace {

constexpr double noticeable_jump = 1e-3;

std::vector<double> cell_widths(const std::vector<double>& edges) {
  std::vector<double> widths;
  for (std::size_t i = 1; i < edges.size(); ++i) {
    widths.push_back(edges[i] - edges[i - 1]);
  }
  return widths;
}

std::vector<double> hat_integrals(const std::vector<double>& nodes) {
  std::vector<double> integrals(nodes.size(), 0.0);
  for (std::size_t i = 1; i < nodes.size(); ++i) {
    const double half = 0.5 * (nodes[i] - nodes[i - 1]);
    integrals[i - 1] += half;
    integrals[i] += half;
  }
  return integrals;
}

// Volume that each value of the grid represents, [z][y][x] [m3].
std::vector<double> value_volumes(const history::StrainGrid& grid) {
  const std::vector<double> dx = cell_widths(grid.x_edges);
  const std::vector<double> dy = cell_widths(grid.y_edges);
  std::vector<double> volumes;
  for (double hz : hat_integrals(grid.z_nodes)) {
    for (double hy : dy) {
      for (double hx : dx) {
        volumes.push_back(hx * hy * hz);
      }
    }
  }
  return volumes;
}

// Rate of change of a channel over the step that starts at a sample, [z][y][x] [unit of the
// channel/s].
std::vector<double> rate_of_step(const history::CoreHistory& history,
                                 const history::HistoryChannel& channel, std::size_t step) {
  const history::StrainField& before = *channel.samples[step];
  const history::StrainField& after = *channel.samples[step + 1];
  std::vector<double> rate(before.size(), 0.0);
  if (&before != &after) {
    const double duration = history.time[step + 1] - history.time[step];
    for (std::size_t i = 0; i < rate.size(); ++i) {
      rate[i] = (after[i] - before[i]) / duration;
    }
  }
  return rate;
}

double integral_of_magnitude(const std::vector<double>& values,
                             const std::vector<double>& volumes) {
  double sum = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    sum += std::abs(values[i]) * volumes[i];
  }
  return sum;
}

// Magnitudes of the jumps of a rate at the inner samples, and the largest magnitude of the rate
// itself.
struct Jumps {
  std::vector<double> at_inner_samples;
  double largest = 0;

  bool noticeable(std::size_t inner) const {
    return at_inner_samples[inner] > noticeable_jump * largest;
  }
};

Jumps rate_jumps(const history::CoreHistory& history, const history::HistoryChannel& channel,
                 const std::vector<double>& volumes) {
  Jumps jumps;
  std::vector<double> rate = rate_of_step(history, channel, 0);
  jumps.largest = integral_of_magnitude(rate, volumes);
  for (std::size_t step = 1; step + 1 < history.time.size(); ++step) {
    const std::vector<double> next = rate_of_step(history, channel, step);
    jumps.largest = std::max(jumps.largest, integral_of_magnitude(next, volumes));
    for (std::size_t i = 0; i < rate.size(); ++i) {
      rate[i] = next[i] - rate[i];
    }
    jumps.at_inner_samples.push_back(integral_of_magnitude(rate, volumes));
    rate = next;
  }
  return jumps;
}

Jumps velocity_jumps(const std::vector<double>& time, const std::vector<double>& position) {
  Jumps jumps;
  double velocity = 0;
  for (std::size_t step = 0; step + 1 < position.size(); ++step) {
    const double next = (position[step + 1] - position[step]) / (time[step + 1] - time[step]);
    jumps.largest = std::max(jumps.largest, std::abs(next));
    if (step > 0) {
      jumps.at_inner_samples.push_back(std::abs(next - velocity));
    }
    velocity = next;
  }
  jumps.at_inner_samples.resize(time.size() - 2, 0.0);
  return jumps;
}

bool is_zero(const history::StrainField& field) {
  return std::all_of(field.begin(), field.end(), [](double value) { return value == 0; });
}

} // namespace

std::vector<double> detect_events(const history::CoreHistory& history) {
  std::vector<Jumps> rates;
  for (const history::HistoryChannel& channel : history.channels) {
    rates.push_back(rate_jumps(history, channel, value_volumes(history.grid)));
  }
  const Jumps along_x = velocity_jumps(history.time, history.slider_x);
  const Jumps along_y = velocity_jumps(history.time, history.slider_y);
  std::vector<double> events{history.time.front()};
  for (std::size_t inner = 0; inner + 2 < history.time.size(); ++inner) {
    const bool slider_jumps = along_x.noticeable(inner) || along_y.noticeable(inner);
    const bool loaded = std::ranges::any_of(history.channels, [inner](const auto& channel) {
      return !is_zero(*channel.samples[inner + 1]);
    });
    const bool kink =
        std::ranges::any_of(rates, [inner](const Jumps& rate) { return rate.noticeable(inner); });
    if (kink || (slider_jumps && loaded)) {
      events.push_back(history.time[inner + 1]);
    }
  }
  return events;
}

} // namespace ionskin::results
