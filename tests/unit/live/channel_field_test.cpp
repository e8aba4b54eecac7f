// SPDX-License-Identifier: Apache-2.0
#include "ionskin/live/channel_field.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace ionskin::live {
namespace {

/// Two cells of contact, two points whose strain has two rows, and on two levels three modes that
/// ride with the slider, 4 x 3 cells with edges at uneven distances, and one that stays with the
/// skin; all numbers different.
ChannelMap uneven_map() {
  ChannelMap map;
  map.rows_per_point = 2;
  map.strain.lines_x = {0, 2};
  map.strain.lines_y = {0};
  map.strain.amplitude = {-0.5, 0.5};
  for (int i = 0; i < 2 * 6 * 4; ++i) {
    map.strain.values.push_back(static_cast<float>(std::sin(1.0 + 3 * i)));
  }
  map.x_edges = {-2, -1.2, 0, 0.3, 2};
  map.y_edges = {-1, -0.5, 0.4, 1};
  map.mean = {1, 1};
  map.moment = {-1, 1};
  map.fit = {{0, 2}, {0}, {-0.5, 0.5}, {}};
  for (int i = 0; i < 2 * 4 * 2; ++i) {
    map.fit.values.push_back(static_cast<float>(std::cos(2.0 + i)));
  }
  for (int i = 0; i < 3 * 2 * 3 * 4; ++i) {
    map.field.push_back(static_cast<float>(std::sin(5.0 + 7 * i)));
  }
  map.fixed_x_edges = {0.4, 1.5, 3};
  map.fixed_y_edges = {-0.8, 0.1, 0.9};
  for (int i = 0; i < 2 * 2 * 2; ++i) {
    map.fixed_field.push_back(static_cast<float>(std::sin(4.0 + 5 * i)));
  }
  return map;
}

/// The field's cells one by one, as they are defined.
std::array<double, 2> by_cells(const ChannelMap& map, const std::array<double, 2>& place,
                               const std::array<double, 6>& force,
                               const std::array<double, 4>& corners) {
  const double amplitude = (place[0] - 1) / 2;
  std::array<double, 2> point{}, levels{};
  for (std::size_t p = 0; p < 2; ++p) {
    std::array<double, 2> strain{};
    for (std::size_t i = 0; i < 6; ++i) {
      for (std::size_t row = 0; row < 2; ++row) {
        const std::size_t at = i * 4 + 2 * p + row;
        strain[row] += force[i] * (static_cast<double>(map.strain.values[at]) +
                                   amplitude * static_cast<double>(map.strain.values[24 + at]));
      }
    }
    point[p] = std::hypot(strain[0], strain[1]);
  }
  const auto add = [&](std::size_t mode, const std::vector<float>& field,
                       const std::vector<double>& x_edges, const std::vector<double>& y_edges,
                       const std::array<double, 2>& origin, std::size_t at) {
    const auto fit = [&](std::size_t p) {
      const std::size_t weight = 2 * mode + p;
      return static_cast<double>(map.fit.values[weight]) +
             amplitude * static_cast<double>(map.fit.values[8 + weight]);
    };
    const double of_mode = fit(0) * point[0] + fit(1) * point[1];
    for (std::size_t level = 0; level < 2; ++level) {
      for (std::size_t j = 0; j + 1 < y_edges.size(); ++j) {
        for (std::size_t i = 0; i + 1 < x_edges.size(); ++i, ++at) {
          const double width = std::min(x_edges[i + 1] + origin[0], corners[2]) -
                               std::max(x_edges[i] + origin[0], corners[0]),
                       height = std::min(y_edges[j + 1] + origin[1], corners[3]) -
                                std::max(y_edges[j] + origin[1], corners[1]);
          levels[level] += of_mode * static_cast<double>(field[at]) * std::max(0.0, width) *
                           std::max(0.0, height);
        }
      }
    }
  };
  for (std::size_t mode = 0; mode < 3; ++mode) {
    add(mode, map.field, map.x_edges, map.y_edges, place, mode * 2 * 3 * 4);
  }
  add(3, map.fixed_field, map.fixed_x_edges, map.fixed_y_edges, {0, 0}, 0);
  return levels;
}

TEST(ChannelField, IntegratesOverAnyRectangle) {
  const ChannelMap map = uneven_map();
  ChannelField field(map, 2);
  const std::array<double, 2> place{1.7, 0.2};
  const std::array<double, 6> force{1, 0.3, -0.2, 2, 0.6, 0.1};
  const ChannelField::Touch touch{place, force};
  field.set({&touch, 1});
  ChannelField copy = field;
  for (const std::array<double, 4>& corners : {std::array<double, 4>{-9, -9, 9, 9},
                                               {1, 0, 1.1, 0.1},
                                               {1.5, -9, 2.5, 0.5},
                                               {-9, 0.3, 1.71, 9},
                                               {0.5, -0.3, 1.7, 0.6},
                                               {5, 0, 6, 1},
                                               {-9, -9, -1, -1}}) {
    const auto integral = [&](ChannelField& of) {
      std::array<double, 2> sum{};
      for (const std::size_t side : {0u, 1u, 2u, 3u}) {
        const std::size_t right = side % 2, upper = side / 2;
        std::array<double, 2> own{};
        of.integrate_to(0, place, {corners[2 * right], corners[2 * upper + 1]}, own);
        for (std::size_t level = 0; level < 2; ++level) {
          sum[level] += right == upper ? own[level] : -own[level];
        }
      }
      return sum;
    };
    const std::array<double, 2> levels = integral(field);
    const std::array<double, 2> expected = by_cells(map, place, force, corners);
    for (std::size_t level = 0; level < 2; ++level) {
      EXPECT_NEAR(levels[level], expected[level], 1e-5) << corners[0] << " " << level;
    }
    EXPECT_EQ(integral(copy), levels);
  }
}

} // namespace
} // namespace ionskin::live
