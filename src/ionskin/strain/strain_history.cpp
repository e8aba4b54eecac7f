// SPDX-License-Identifier: Apache-2.0
#include "ionskin/strain/strain_history.hpp"

#include "ionskin/strain/level_integrals.hpp"

#include <algorithm>

namespace ionskin::strain {
namespace {

std::vector<double> shifted(const std::vector<double>& edges, double offset) {
  std::vector<double> result(edges);
  for (double& edge : result) {
    edge += offset;
  }
  return result;
}

double at_bracket(const std::vector<double>& values, const TimeBracket& at) {
  return at.weight == 0 ? values[at.index]
                        : (1 - at.weight) * values[at.index] + at.weight * values[at.index + 1];
}

} // namespace

TimeBracket bracket(const StrainHistory& history, double time) {
  const auto& t = history.time;
  const auto after = std::upper_bound(t.begin(), t.end(), time);
  if (after == t.begin()) {
    return {0, 0.0};
  }
  const auto index = static_cast<std::size_t>(after - t.begin()) - 1;
  if (after == t.end()) {
    return {t.size() - 1, 0.0};
  }
  return {index, (time - t[index]) / (t[index + 1] - t[index])};
}

std::vector<double> skin_x_edges(const StrainHistory& history, const TimeBracket& at) {
  if (history.frame == Frame::skin) {
    return history.grid.x_edges;
  }
  return shifted(history.grid.x_edges, at_bracket(history.slider_x, at));
}

std::vector<double> skin_y_edges(const StrainHistory& history, const TimeBracket& at) {
  if (history.frame == Frame::skin) {
    return history.grid.y_edges;
  }
  const double centre =
      history.slider_y.empty() ? 0.5 * history.width : at_bracket(history.slider_y, at);
  return shifted(history.grid.y_edges, centre);
}

void interpolate_field(const StrainHistory& history, const TimeBracket& at, StrainField& field) {
  const StrainField& before = *history.gamma[at.index];
  field = before;
  if (at.weight == 0) {
    return;
  }
  const StrainField& after = *history.gamma[at.index + 1];
  for (std::size_t i = 0; i < field.size(); ++i) {
    field[i] += at.weight * (after[i] - before[i]);
  }
  keep_level_integrals_linear(history, at, field);
}

} // namespace ionskin::strain
