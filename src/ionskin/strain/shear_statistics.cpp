// SPDX-License-Identifier: Apache-2.0
#include "ionskin/strain/shear_statistics.hpp"

#include "ionskin/strain/level_integrals.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace ionskin::strain {
namespace {

/// The field at an instant with the areas of its columns inside the core.
struct Instant {
  StrainField field;
  std::vector<double> area; ///< [y][x] [m2]

  Instant(const StrainHistory& history, double time) {
    const TimeBracket at = bracket(history, time);
    interpolate_field(history, at, field);
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

/// Value below which the given fraction of the volume lies. Reorders the entries (value, volume).
double percentile(std::vector<std::pair<double, double>>& entries, double total, double fraction) {
  double above_wanted = (1 - fraction) * total;
  auto begin = entries.begin();
  auto end = entries.end();
  while (end - begin > 1) {
    const auto middle = begin + (end - begin) / 2;
    std::nth_element(begin, middle, end);
    double above = 0;
    for (auto i = middle; i != end; ++i) {
      above += i->second;
    }
    if (above >= above_wanted) {
      begin = middle;
    } else {
      above_wanted -= above;
      end = middle;
    }
  }
  return begin == entries.end() ? 0.0 : begin->first;
}

/// Integral over the core of what `mean_of(low, high)` gives as the mean over an interval between
/// two levels [m3].
template <class MeanOf>
double integral(const StrainHistory& history, double time, const MeanOf& mean_of) {
  const Instant instant(history, time);
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

} // namespace

ShearStatistics shear_statistics(const StrainHistory& history, double time) {
  const Instant instant(history, time);
  const auto& z = history.grid.z_nodes;
  const double height = z.back();
  const std::size_t columns = instant.area.size();
  ShearStatistics result;
  double volume = 0;
  std::vector<std::pair<double, double>> entries;
  entries.reserve(columns * (z.size() - 1));
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
      entries.emplace_back(std::abs(mean), cell);
    }
  }
  result.mean /= volume;
  result.first_moment /= volume;
  result.rms = std::sqrt(result.rms / volume);
  result.p95 = percentile(entries, volume, 0.95);
  result.p99 = percentile(entries, volume, 0.99);
  return result;
}

double shear_integral(const StrainHistory& history, double time) {
  return integral(history, time, [](double low, double high) { return 0.5 * (low + high); });
}

double shear_magnitude_integral(const StrainHistory& history, double time) {
  return integral(history, time, [](double low, double high) {
    const double sum = std::abs(low) + std::abs(high);
    return low * high >= 0 ? 0.5 * sum : 0.5 * (low * low + high * high) / sum;
  });
}

} // namespace ionskin::strain
