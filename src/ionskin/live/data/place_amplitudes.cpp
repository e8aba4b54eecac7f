// SPDX-License-Identifier: Apache-2.0
#include "ionskin/live/data/place_amplitudes.hpp"

#include <algorithm>

namespace ionskin::live {
namespace {

/// Computes the Lagrange weights of the lines at a coordinate.
void lagrange(const std::vector<double>& lines, double at, std::span<double> weights) noexcept {
  for (std::size_t i = 0; i < lines.size(); ++i) {
    weights[i] = 1;
    for (std::size_t j = 0; j < lines.size(); ++j) {
      if (j != i) {
        weights[i] *= (at - lines[j]) / (lines[i] - lines[j]);
      }
    }
  }
}

/// Computes the derivatives of the Lagrange weights by the coordinate.
void lagrange_slope(const std::vector<double>& lines, double at,
                    std::span<double> weights) noexcept {
  for (std::size_t i = 0; i < lines.size(); ++i) {
    weights[i] = 0;
    for (std::size_t k = 0; k < lines.size(); ++k) {
      double product = k == i ? 0 : 1 / (lines[i] - lines[k]);
      for (std::size_t j = 0; j < lines.size(); ++j) {
        if (j != i && j != k) {
          product *= (at - lines[j]) / (lines[i] - lines[j]);
        }
      }
      weights[i] += product;
    }
  }
}

using LineWeights = std::array<double, most_lines>;

/// Sums the amplitudes at the nodes, weighted along x and along y.
void add_nodes(const PlaceMap& map, const LineWeights& x, const LineWeights& y,
               std::span<double> amplitudes) noexcept {
  std::fill(amplitudes.begin(), amplitudes.end(), 0.0);
  const std::size_t modes = map.modes();
  for (std::size_t j = 0, node = 0; j < map.lines_y.size(); ++j) {
    for (std::size_t i = 0; i < map.lines_x.size(); ++i, ++node) {
      for (std::size_t k = 0; k < modes; ++k) {
        amplitudes[k] += x[i] * y[j] * map.amplitude[modes * node + k];
      }
    }
  }
}

} // namespace

void place_slopes(const PlaceMap& map, const std::array<double, 2>& place, std::size_t direction,
                  std::span<double> slopes) noexcept {
  LineWeights x{}, y{};
  (direction == 0 ? lagrange_slope : lagrange)(map.lines_x, place[0], x);
  (direction == 1 ? lagrange_slope : lagrange)(map.lines_y, place[1], y);
  add_nodes(map, x, y, slopes);
}

void place_amplitudes(const PlaceMap& map, const std::array<double, 2>& place,
                      std::span<double> amplitudes) noexcept {
  LineWeights x{}, y{};
  lagrange(map.lines_x, place[0], x);
  lagrange(map.lines_y, place[1], y);
  add_nodes(map, x, y, amplitudes);
}

} // namespace ionskin::live
