// SPDX-License-Identifier: Apache-2.0
#include "ionskin/history/core_history.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/history/level_integrals.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace ionskin::history {
namespace {

struct KnownChannel {
  std::string name, unit;
  double largest;
};
const std::array known{KnownChannel{channel_name::shear, "1", 1e3},
                       KnownChannel{channel_name::dilation, "1", 1e3},
                       KnownChannel{channel_name::undrained_pressure, "Pa", 1e12}};

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

double largest_magnitude(const HistoryChannel& channel) {
  double largest = 0.0;
  const StrainField* seen = nullptr;
  for (const auto& field : channel.samples) {
    if (field.get() != seen) {
      seen = field.get();
      for (const double value : *seen) {
        largest = std::max(largest, std::abs(value));
      }
    }
  }
  return largest;
}

TimeBracket bracket(const CoreHistory& history, double time) {
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

std::vector<double> skin_x_edges(const CoreHistory& history, const TimeBracket& at) {
  if (history.frame == Frame::skin) {
    return history.grid.x_edges;
  }
  return shifted(history.grid.x_edges, at_bracket(history.slider_x, at));
}

std::vector<double> skin_y_edges(const CoreHistory& history, const TimeBracket& at) {
  if (history.frame == Frame::skin) {
    return history.grid.y_edges;
  }
  const double centre =
      history.slider_y.empty() ? 0.5 * history.width : at_bracket(history.slider_y, at);
  return shifted(history.grid.y_edges, centre);
}

const std::string* unit_of_channel(std::string_view name) {
  const auto found = std::ranges::find(known, name, &KnownChannel::name);
  return found == known.end() ? nullptr : &found->unit;
}

double largest_of_channel(std::string_view name) {
  const auto found = std::ranges::find(known, name, &KnownChannel::name);
  return found == known.end() ? 0.0 : found->largest;
}

std::string known_channels() {
  std::string names;
  for (const KnownChannel& channel : known) {
    names += (names.empty() ? "" : ", ") + channel.name;
  }
  return names;
}

const HistoryChannel* CoreHistory::find(std::string_view name) const {
  const auto found = std::ranges::find(channels, name, &HistoryChannel::name);
  return found == channels.end() ? nullptr : &*found;
}

const HistoryChannel& CoreHistory::channel(std::string_view name) const {
  if (const HistoryChannel* found = find(name)) {
    return *found;
  }
  throw InternalError("the history has no channel " + std::string(name));
}

HistoryChannel& CoreHistory::add_channel(const std::string& name, const std::string& unit) {
  const auto found = std::ranges::find(channels, name, &HistoryChannel::name);
  return found == channels.end() ? channels.emplace_back(HistoryChannel{name, unit, {}}) : *found;
}

void interpolate_field(const CoreHistory& history, const HistoryChannel& channel,
                       const TimeBracket& at, StrainField& field) {
  const StrainField& before = *channel.samples[at.index];
  field = before;
  if (at.weight == 0) {
    return;
  }
  const StrainField& after = *channel.samples[at.index + 1];
  for (std::size_t i = 0; i < field.size(); ++i) {
    field[i] += at.weight * (after[i] - before[i]);
  }
  keep_level_integrals_linear(history, channel, at, field);
}

} // namespace ionskin::history
