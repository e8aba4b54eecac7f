// SPDX-License-Identifier: Apache-2.0
#include "ionskin/live/charge_spread.hpp"
#include "ionskin/live/low_pass.hpp"
#include "small_skin.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ionskin::live {
namespace {

/// Integral over a column of the weighted levels of a field of modes, cell by cell.
double column_integral(const SkinData& data, const std::array<double, 2>& place,
                       const std::vector<double>& amplitude, std::size_t i, std::size_t j) {
  const ChannelMap& channel = data.channels.back();
  const double dx = data.length / static_cast<double>(data.spread.columns_x),
               dy = data.width / static_cast<double>(data.spread.columns_y);
  const auto overlap = [](double low, double high, double from, double to) {
    return std::max(0.0, std::min(high, to) - std::max(low, from));
  };
  const std::size_t levels = data.spread.weights.size();
  double sum = 0;
  const auto add = [&](const std::vector<float>& field, const std::vector<double>& x_edges,
                       const std::vector<double>& y_edges, const std::array<double, 2>& origin,
                       std::size_t first_mode) {
    const std::size_t columns = x_edges.size() - 1, rows = y_edges.size() - 1;
    for (std::size_t at = 0; at < field.size(); ++at) {
      const std::size_t column = at % columns, row = at / columns % rows,
                        level = at / columns / rows % levels, mode = at / columns / rows / levels;
      sum += amplitude[first_mode + mode] * data.spread.weights[level] *
             static_cast<double>(field[at]) *
             overlap(x_edges[column] + origin[0], x_edges[column + 1] + origin[0],
                     dx * static_cast<double>(i), dx * static_cast<double>(i + 1)) *
             overlap(y_edges[row] + origin[1], y_edges[row + 1] + origin[1],
                     dy * static_cast<double>(j), dy * static_cast<double>(j + 1));
    }
  };
  add(channel.field, channel.x_edges, channel.y_edges, place, 0);
  add(channel.fixed_field, channel.fixed_x_edges, channel.fixed_y_edges, {0, 0}, 2);
  return sum;
}

TEST(ChargeSpread, IsDrivenByTheIntegralsOverItsColumns) {
  SkinData data = small_skin();
  ChannelMap& channel = data.channels.back();
  channel.fixed_x_edges = {0, 0.7e-3, 4e-3, 6e-3}; // a mode that stays with the skin
  channel.fixed_y_edges = {0, 1.3e-3, 2e-3};
  for (int i = 0; i < 2 * 3 * 2; ++i) {
    channel.fixed_field.push_back(static_cast<float>(std::sin(1.0 + 3 * i)));
  }
  ChargeSpread spread(data);
  const std::vector<double> amplitude{0.3, -0.8, 0.6};
  std::vector<double> waves(spread.waves());
  for (const std::array<double, 2>& place :
       {std::array<double, 2>{1.7e-3, 1e-3}, {5e-3, 0.6e-3}, {0.4e-3, 1.3e-3}}) {
    spread.drive(place, amplitude, waves);
    for (std::size_t wave = 0; wave < waves.size(); ++wave) {
      double expected = 0;
      for (std::size_t j = 0; j < 2; ++j) {
        for (std::size_t i = 0; i < 6; ++i) {
          expected += column_wave(6, data.spread.wave_x[wave], i) *
                      column_wave(2, data.spread.wave_y[wave], j) *
                      column_integral(data, place, amplitude, i, j);
        }
      }
      EXPECT_NEAR(waves[wave], expected, 1e-12) << place[0] << " " << wave;
    }
  }
}

TEST(ChargeSpread, FollowsALadderOfCapacitors) {
  // dq/dt = g (differences of q - u between neighbours), stepped straight on 6 columns, against the
  // waves of q: what has spread is -(low pass of u), wave by wave, beside u itself.
  SkinData data = small_skin();
  constexpr std::size_t columns = 6;
  constexpr double conductance = 3;
  data.spread = {columns, 1, {}, {}, {}, {1, 0}};
  for (std::size_t wave = 1; wave < columns; ++wave) {
    data.spread.wave_x.push_back(wave);
    data.spread.wave_y.push_back(0);
    data.spread.rates.push_back(
        4 * conductance *
        std::pow(std::sin(std::numbers::pi * static_cast<double>(wave) / (2 * columns)), 2));
  }
  const std::array<double, 2> place{1.2e-3, 1e-3};
  const std::vector<double> amplitude{2, 0};
  ChargeSpread spread(data);
  std::vector<double> drive(columns - 1);
  spread.drive(place, amplitude, drive);
  std::array<double, columns> source{}, charge{};
  for (std::size_t i = 0; i < columns; ++i) {
    source[i] = column_integral(data, place, amplitude, i, 0);
  }
  constexpr int steps = 20000;
  constexpr double time = 0.4;
  for (int step = 0; step < steps; ++step) {
    std::array<double, columns> next = charge;
    for (std::size_t i = 0; i + 1 < columns; ++i) {
      const double flow =
          conductance * time / steps * ((charge[i] + source[i]) - (charge[i + 1] + source[i + 1]));
      next[i] -= flow;
      next[i + 1] += flow;
    }
    charge = next;
  }
  std::vector<double> relaxed;
  for (std::size_t wave = 0; wave < drive.size(); ++wave) {
    const LowPass pass = LowPass::over(data.spread.rates[wave], time);
    relaxed.push_back(-(pass.before + pass.now) * drive[wave]);
  }
  const double largest = std::abs(*std::ranges::max_element(source));
  EXPECT_NEAR(spread.charge(0, relaxed), charge[0] + charge[1] + charge[2], 1e-4 * largest);
  EXPECT_NEAR(spread.charge(1, relaxed), charge[3] + charge[4] + charge[5], 1e-4 * largest);
  EXPECT_GT(std::abs(charge[3] + charge[4] + charge[5]), 1e-2 * largest);
}

} // namespace
} // namespace ionskin::live
