// SPDX-License-Identifier: Apache-2.0
#include "ionskin/history/shear_statistics.hpp"

#include "ionskin/history/level_integrals.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

namespace ionskin::history {
namespace {

/// A channel at an instant, with the areas of the grid's columns inside the core.
struct Instant {
  StrainField field;
  std::vector<double> area; ///< [y][x] [m2]

  Instant(const CoreHistory& history, const HistoryChannel& channel, double time) {
    const TimeBracket at = bracket(history, time);
    interpolate_field(history, channel, at, field);
    const auto dx = lengths_within(skin_x_edges(history, at), history.length);
    const auto dy = lengths_within(skin_y_edges(history, at), history.width);
    area.reserve(dx.size() * dy.size());
    for (const double y : dy) {
      for (const double x : dx) {
        area.push_back(x * y);
      }
    }
  }
};

struct Sample {
  double magnitude = 0;
  double volume = 0; ///< [m3]
};

/// Narrows samples to those of largest magnitude that fill a given volume [m3].
/// @returns the smallest magnitude among them
double narrow_to_top(std::span<Sample>& samples, double volume) {
  std::size_t begin = 0, end = samples.size();
  while (end - begin > 1) {
    const std::size_t middle = begin + (end - begin) / 2;
    const auto open = samples.subspan(begin, end - begin);
    std::ranges::nth_element(open, open.begin() + static_cast<std::ptrdiff_t>(middle - begin), {},
                             &Sample::magnitude);
    double above = 0;
    for (const Sample& sample : samples.subspan(middle, end - middle)) {
      above += sample.volume;
    }
    if (above >= volume) {
      begin = middle;
    } else {
      volume -= above;
      end = middle;
    }
  }
  samples = samples.subspan(begin);
  return samples.empty() ? 0.0 : samples.front().magnitude;
}

/// Integral of a channel over the core [unit of the channel times m3].
/// @param mean_of mean over an interval between two z nodes, from the values at the nodes
template <class MeanOf>
double integral(const CoreHistory& history, const Instant& instant, const MeanOf& mean_of) {
  const auto& z = history.grid.z_nodes;
  const std::size_t columns = instant.area.size();
  double integral = 0;
  for (std::size_t k = 0; k + 1 < z.size(); ++k) {
    double slice = 0;
    for (std::size_t c = 0; c < columns; ++c) {
      slice += instant.area[c] *
               mean_of(instant.field[k * columns + c], instant.field[(k + 1) * columns + c]);
    }
    integral += (z[k + 1] - z[k]) * slice;
  }
  return integral;
}

double mean_shear(double low, double high) {
  return 0.5 * (low + high);
}

double mean_magnitude(double low, double high) {
  const double sum = std::abs(low) + std::abs(high);
  return low * high >= 0 ? 0.5 * sum : 0.5 * (low * low + high * high) / sum;
}

} // namespace

ShearStatistics shear_statistics(const CoreHistory& history, double time) {
  const HistoryChannel* shear = history.find(channel_name::shear);
  if (shear == nullptr) {
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    return {unknown, unknown, unknown, unknown, unknown, unknown};
  }
  const Instant instant(history, *shear, time);
  const auto& z = history.grid.z_nodes;
  const double height = z.back();
  const std::size_t columns = instant.area.size();
  ShearStatistics result;
  double volume = 0;
  std::vector<Sample> samples;
  samples.reserve(columns * (z.size() - 1));
  for (std::size_t k = 0; k + 1 < z.size(); ++k) {
    const double dz = z[k + 1] - z[k];
    for (std::size_t c = 0; c < columns; ++c) {
      if (instant.area[c] <= 0) {
        continue;
      }
      const double low = instant.field[k * columns + c];
      const double high = instant.field[(k + 1) * columns + c];
      const double cell = instant.area[c] * dz;
      const double mean = 0.5 * (low + high);
      const double centre = 0.5 * (z[k] + z[k + 1]) / height - 0.5;
      volume += cell;
      result.mean += cell * mean;
      result.rms += cell * (low * low + low * high + high * high) / 3;
      result.first_moment += cell * (mean * centre + (high - low) * dz / (12 * height));
      result.element_max = std::max(result.element_max, std::abs(mean));
      samples.push_back({std::abs(mean), cell});
    }
  }
  result.mean /= volume;
  result.first_moment /= volume;
  result.rms = std::sqrt(result.rms / volume);
  std::span<Sample> top(samples);
  result.p95 = narrow_to_top(top, 0.05 * volume);
  result.p99 = narrow_to_top(top, 0.01 * volume);
  return result;
}

double shear_integral(const CoreHistory& history, double time) {
  return integral(history, Instant(history, history.channel(channel_name::shear), time),
                  mean_shear);
}

ChannelIntegrals channel_integrals(const CoreHistory& history, const HistoryChannel& channel,
                                   double time) {
  const Instant instant(history, channel, time);
  return {integral(history, instant, mean_shear), integral(history, instant, mean_magnitude)};
}

} // namespace ionskin::history
