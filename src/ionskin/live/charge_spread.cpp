// SPDX-License-Identifier: Apache-2.0
#include "ionskin/live/charge_spread.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ionskin::live {
namespace {

/// Integrals over x and y of fields on a grid, summed over the z levels with weights, from the
/// lowest corner of the grid to each crossing of its edges [mode][y edge][x edge].
/// @param fields [mode][level][y][x]
/// @param x_edges, y_edges edges of the grid [m]
/// @param weights [level] [C/m2]
std::vector<float> weighted_integrals(const std::vector<float>& fields,
                                      const std::vector<double>& x_edges,
                                      const std::vector<double>& y_edges,
                                      const std::vector<double>& weights) {
  const std::size_t columns = x_edges.size() - 1, rows = y_edges.size() - 1,
                    levels = weights.size(), modes = fields.size() / (levels * rows * columns);
  std::vector<float> result(modes * (rows + 1) * (columns + 1));
  for (std::size_t mode = 0; mode < modes; ++mode) {
    float* integral = result.data() + mode * (rows + 1) * (columns + 1);
    std::vector<double> below(columns + 1); // integrals to each x edge, up to the present y edge
    for (std::size_t j = 0; j < rows; ++j) {
      const double height = y_edges[j + 1] - y_edges[j];
      double row = 0;
      for (std::size_t i = 0; i < columns; ++i) {
        double value = 0;
        for (std::size_t level = 0; level < levels; ++level) {
          value += weights[level] *
                   static_cast<double>(fields[((mode * levels + level) * rows + j) * columns + i]);
        }
        row += height * (x_edges[i + 1] - x_edges[i]) * value;
        below[i + 1] += row;
        integral[(j + 1) * (columns + 1) + i + 1] = static_cast<float>(below[i + 1]);
      }
    }
  }
  return result;
}

} // namespace

double column_wave(std::size_t columns, std::uint64_t wave, std::size_t column) {
  const auto count = static_cast<double>(columns);
  return std::sqrt((wave == 0 ? 1 : 2) / count) *
         std::cos(std::numbers::pi * static_cast<double>(wave) *
                  (static_cast<double>(column) + 0.5) / count);
}

std::vector<double> column_shares(std::size_t columns, double length, double low, double high) {
  std::vector<double> shares;
  const double width = length / static_cast<double>(columns);
  for (std::size_t i = 0; i < columns; ++i) {
    const double from = width * static_cast<double>(i);
    shares.push_back(
        std::clamp((std::min(high, from + width) - std::max(low, from)) / width, 0.0, 1.0));
  }
  return shares;
}

ChargeSpread::ChargeSpread(const SkinData& data) : data_(data) {
  const SpreadMap& map = data.spread;
  if (map.rates.empty()) {
    return;
  }
  const ChannelMap& channel = data.channels.back();
  integral_ = weighted_integrals(channel.field, channel.x_edges, channel.y_edges, map.weights);
  std::vector<std::uint64_t> rows;
  for (std::size_t wave = 0; wave < waves(); ++wave) {
    const auto known = std::ranges::find(rows, map.wave_y[wave]);
    row_of_.push_back(static_cast<std::size_t>(known - rows.begin()));
    if (known == rows.end()) {
      rows.push_back(map.wave_y[wave]);
      for (std::size_t j = 0; j < map.columns_y; ++j) {
        along_y_.push_back(static_cast<float>(column_wave(map.columns_y, rows.back(), j)));
      }
    }
    for (std::size_t i = 0; i < map.columns_x; ++i) {
      along_x_.push_back(static_cast<float>(column_wave(map.columns_x, map.wave_x[wave], i)));
    }
  }
  for (std::size_t taxel = 0; taxel < data.taxels.size(); ++taxel) {
    const double* corners = &data.taxel_corners[4 * taxel];
    const auto x = column_shares(map.columns_x, data.length, corners[0], corners[2]),
               y = column_shares(map.columns_y, data.width, corners[1], corners[3]);
    for (std::size_t wave = 0; wave < waves(); ++wave) {
      double in_x = 0, in_y = 0;
      for (std::size_t i = 0; i < x.size(); ++i) {
        in_x += x[i] * column_wave(map.columns_x, map.wave_x[wave], i);
      }
      for (std::size_t j = 0; j < y.size(); ++j) {
        in_y += y[j] * column_wave(map.columns_y, map.wave_y[wave], j);
      }
      share_.push_back(in_x * in_y);
    }
  }
  set_fixed_drive(channel);
  edge_.resize(map.columns_x + 1);
  node_.resize(channel.x_edges.size() * channel.y_edges.size());
  lower_.resize(channel.x_edges.size());
  upper_.resize(channel.x_edges.size());
  column_.resize(map.columns_x);
  sum_.resize(rows.size() * map.columns_x);
}

void ChargeSpread::set_fixed_drive(const ChannelMap& channel) {
  const SpreadMap& map = data_.spread;
  const std::vector<double>&x_edges = channel.fixed_x_edges, &y_edges = channel.fixed_y_edges;
  const std::vector<float> integral =
      weighted_integrals(channel.fixed_field, x_edges, y_edges, map.weights);
  const auto at = [](const std::vector<double>& edges, double extent, std::size_t column,
                     std::size_t columns) {
    return between(edges, extent * static_cast<double>(column) / static_cast<double>(columns));
  };
  for (std::size_t first = 0; first < integral.size(); first += x_edges.size() * y_edges.size()) {
    const auto up_to = [&](std::size_t i, std::size_t j) {
      const Between x = at(x_edges, data_.length, i, map.columns_x),
                    y = at(y_edges, data_.width, j, map.columns_y);
      double sum = 0;
      for (std::size_t node = 0; node < 4; ++node) {
        sum += x.weight[node % 2] * y.weight[node / 2] *
               static_cast<double>(
                   integral[first + y.edge[node / 2] * x_edges.size() + x.edge[node % 2]]);
      }
      return sum;
    };
    std::vector<double> drive(waves());
    for (std::size_t j = 0; j < map.columns_y; ++j) {
      for (std::size_t i = 0; i < map.columns_x; ++i) {
        const double own = up_to(i + 1, j + 1) - up_to(i, j + 1) - up_to(i + 1, j) + up_to(i, j);
        for (std::size_t wave = 0; wave < waves(); ++wave) {
          drive[wave] += own * column_wave(map.columns_x, map.wave_x[wave], i) *
                         column_wave(map.columns_y, map.wave_y[wave], j);
        }
      }
    }
    fixed_drive_.insert(fixed_drive_.end(), drive.begin(), drive.end());
  }
}

void ChargeSpread::row_at(const Between& at, std::vector<float>& row) const noexcept {
  const std::size_t size = row.size();
  const float *first = node_.data() + at.edge[0] * size, *second = node_.data() + at.edge[1] * size;
  const auto low = static_cast<float>(at.weight[0]), high = static_cast<float>(at.weight[1]);
  for (std::size_t i = 0; i < size; ++i) {
    row[i] = low * first[i] + high * second[i];
  }
}

void ChargeSpread::drive(const std::array<double, 2>& place, std::span<const double> amplitude,
                         std::span<double> waves, Along derivative) noexcept {
  const SpreadMap& map = data_.spread;
  const std::size_t columns = map.columns_x, rows = sum_.size() / columns;
  std::ranges::fill(node_, 0.0f);
  const float* integral = integral_.data();
  const std::size_t riding = integral_.size() / node_.size();
  for (const double value : amplitude.first(riding)) {
    const auto scale = static_cast<float>(value);
    for (float& node : node_) {
      node += scale * *integral++;
    }
  }
  // Derivatives change their sign: as the slider moves forward, a column moves backward in the
  // slider's frame.
  const auto from_slider = [](const std::vector<double>& edges, double at, bool slopes) {
    Between result = slopes ? slope_between(edges, at) : between(edges, at);
    for (double& weight : result.weight) {
      weight *= slopes ? -1 : 1;
    }
    return result;
  };
  for (std::size_t i = 0; i <= columns; ++i) {
    const double x = data_.length * static_cast<double>(i) / static_cast<double>(columns);
    edge_[i] = from_slider(data_.channels.back().x_edges, x - place[0], derivative == Along::x);
  }
  const auto row_to = [&](std::size_t j, std::vector<float>& row) {
    const double y = data_.width * static_cast<double>(j) / static_cast<double>(map.columns_y);
    row_at(from_slider(data_.channels.back().y_edges, y - place[1], derivative == Along::y), row);
  };
  std::ranges::fill(sum_, 0.0f);
  row_to(0, lower_);
  for (std::size_t j = 0; j < map.columns_y; ++j) {
    row_to(j + 1, upper_);
    for (std::size_t i = 0; i < lower_.size(); ++i) {
      lower_[i] = upper_[i] - lower_[i];
    }
    float last = 0;
    for (std::size_t i = 0; i <= columns; ++i) {
      const Between& at = edge_[i];
      const float value = static_cast<float>(at.weight[0]) * lower_[at.edge[0]] +
                          static_cast<float>(at.weight[1]) * lower_[at.edge[1]];
      if (i > 0) {
        column_[i - 1] = value - last;
      }
      last = value;
    }
    for (std::size_t row = 0; row < rows; ++row) {
      const float scale = along_y_[row * map.columns_y + j];
      float* sum = sum_.data() + row * columns;
      for (std::size_t i = 0; i < columns; ++i) {
        sum[i] += scale * column_[i];
      }
    }
    std::swap(lower_, upper_);
  }
  for (std::size_t wave = 0; wave < waves.size(); ++wave) {
    const float *along = along_x_.data() + wave * columns,
                *sum = sum_.data() + row_of_[wave] * columns;
    double value = 0;
    for (std::size_t i = 0; i < columns; ++i) {
      value += static_cast<double>(along[i] * sum[i]);
    }
    for (std::size_t mode = riding; derivative == Along::none && mode < amplitude.size(); ++mode) {
      value += amplitude[mode] * fixed_drive_[(mode - riding) * waves.size() + wave];
    }
    waves[wave] = value;
  }
}

double ChargeSpread::charge(std::size_t taxel, std::span<const double> relaxed) const noexcept {
  const double* share = share_.data() + taxel * relaxed.size();
  double sum = 0;
  for (std::size_t wave = 0; wave < relaxed.size(); ++wave) {
    sum += share[wave] * relaxed[wave];
  }
  return sum;
}

} // namespace ionskin::live
