// SPDX-License-Identifier: Apache-2.0
#include "ionskin/history/level_integrals.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace ionskin::history {
namespace {

constexpr double largest_change = 0.5;

struct LevelIntegral {
  double value = 0, magnitude = 0; ///< of gamma and of |gamma| [m2]
};

std::vector<LevelIntegral> level_integrals(const CoreHistory& history, const TimeBracket& at,
                                           const StrainField& field) {
  const auto dx = lengths_within(skin_x_edges(history, at), history.length);
  const auto dy = lengths_within(skin_y_edges(history, at), history.width);
  std::vector<LevelIntegral> result(history.grid.z_nodes.size());
  const double* value = field.data();
  for (LevelIntegral& level : result) {
    for (const double y : dy) {
      double sum = 0, magnitude = 0;
      for (const double x : dx) {
        sum += x * *value;
        magnitude += x * std::abs(*value);
        ++value;
      }
      level.value += y * sum;
      level.magnitude += y * magnitude;
    }
  }
  return result;
}

} // namespace

std::vector<double> lengths_within(const std::vector<double>& edges, double extent) {
  std::vector<double> result(edges.size() - 1);
  for (std::size_t i = 0; i < result.size(); ++i) {
    result[i] = std::max(0.0, std::min(edges[i + 1], extent) - std::max(edges[i], 0.0));
  }
  return result;
}

void keep_level_integrals_linear(const CoreHistory& history, const HistoryChannel& channel,
                                 const TimeBracket& at, StrainField& field) {
  if (history.frame == Frame::skin || at.weight == 0) {
    return;
  }
  const auto before = level_integrals(history, {at.index, 0.0}, *channel.samples[at.index]);
  const auto after = level_integrals(history, {at.index + 1, 0.0}, *channel.samples[at.index + 1]);
  const auto now = level_integrals(history, at, field);
  const std::size_t columns = history.grid.columns_x() * history.grid.columns_y();
  for (std::size_t k = 0; k < now.size(); ++k) {
    if (now[k].magnitude > 0) {
      const double wanted = (1 - at.weight) * before[k].value + at.weight * after[k].value;
      const double change =
          std::clamp((wanted - now[k].value) / now[k].magnitude, -largest_change, largest_change);
      for (std::size_t i = k * columns; i < (k + 1) * columns; ++i) {
        field[i] += change * std::abs(field[i]);
      }
    }
  }
}

} // namespace ionskin::history
