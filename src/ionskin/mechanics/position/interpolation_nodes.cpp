// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/position/interpolation_nodes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace ionskin::mechanics {

namespace {

/// Of the interval from -1 to 1.
std::vector<double> unit_nodes(std::size_t count, bool in_pairs) {
  // Distances of pairs from the middle. Found by search for small Lebesgue constants: pairs alone
  // have 2.6, 2.1, 3.4 and 2.5 at 4, 6, 8 and 10 nodes and at most 8; those that follow the ends
  // and the middle 1.6 at 5 nodes and 4.0 at 6, at most 11.
  constexpr std::array<double, most_interpolation_nodes / 2> alone{1,     0.176, 0.7,   0.923,
                                                                   0.464, 0.867, 0.304, 0.788};
  constexpr std::array<double, most_interpolation_nodes / 2> beside_middle{
      1, 0.615, 0.837, 0.283, 0.96, 0.437, 0.902, 0.72};
  std::vector<double> nodes;
  for (const double pair : in_pairs ? alone : beside_middle) {
    nodes.insert(nodes.end(), {-pair, pair});
  }
  if (!in_pairs || count % 2 == 1) {
    nodes.insert(nodes.begin() + static_cast<std::ptrdiff_t>(in_pairs ? count - 1 : 2), 0.0);
  }
  nodes.resize(count);
  std::ranges::sort(nodes);
  return nodes;
}

} // namespace

double EndCoordinate::at(double place) const {
  return std::log((place - first) / (last - place));
}

double EndCoordinate::place(double coordinate) const {
  const double ratio = std::exp(coordinate);
  return (first + ratio * last) / (1 + ratio);
}

EndCoordinate end_coordinate(double low, double high, double size) {
  // A slider that covers the skin may be anywhere; no end is near it.
  return {low > 0 ? 0 : low - size, high < size ? size : high + size};
}

bool mirrored_places(double low, double high, double size) {
  constexpr double rounding = 1e-9;
  return std::abs(low + high - size) <= rounding * size;
}

std::vector<double> interpolation_nodes(const EndCoordinate& coordinate, double low, double high,
                                        std::size_t count, bool in_pairs) {
  const double first = coordinate.at(low), last = coordinate.at(high);
  std::vector<double> nodes;
  for (const double node : unit_nodes(count, in_pairs)) {
    nodes.push_back(coordinate.place((first + last) / 2 + node * (last - first) / 2));
  }
  nodes.front() = low;
  nodes.back() = high;
  return nodes;
}

std::vector<double> interpolation_weights(const std::vector<double>& nodes, double at) {
  std::vector<double> weights(nodes.size(), 1.0);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    for (std::size_t j = 0; j < nodes.size(); ++j) {
      if (i != j) {
        weights[i] *= (at - nodes[j]) / (nodes[i] - nodes[j]);
      }
    }
  }
  return weights;
}

ExpectedNodes expected_nodes(const Case& input, std::size_t axis, double low, double high) {
  // The error falls by the decay with each node. Over half of the room that the slider has on the
  // skin, so many keep the tolerance of coarse and standard, as on cases/paper.toml under a sharp
  // slider and on cases/finger.toml under another one, and ten that of fine.
  constexpr double usual_decay = 0.2, usual_share = 0.5;
  const double usual_count =
      input.numerics.preset == Preset::fine ? 10 : (input.slider.sharp() ? 6 : 4.9);
  const double size = axis == 0 ? input.skin.length : input.skin.width,
               room = size - 2 * input.slider.flat_half_size()[axis];
  const double share = std::min(1.0, (high - low) / std::max(room, high - low) / usual_share);
  const double count = usual_count * std::log(usual_decay) / std::log(usual_decay * share);
  // Every run that shares positions pays for each of them. Over a narrow rectangle two lines may
  // do; the error of the strain between them tells.
  constexpr double narrow_count = 4;
  if (input.numerics.shared.given() && count < narrow_count) {
    return {2, 2};
  }
  constexpr double rounding = 1e-9; // of lengths, differences of coordinates: must not cost a node
  const auto down = static_cast<std::size_t>(count + rounding),
             up = static_cast<std::size_t>(std::ceil(count - rounding));
  const bool in_pairs = mirrored_places(low, high, size);
  const std::size_t all = std::clamp<std::size_t>(in_pairs ? up + up % 2 : up, 2,
                                                  most_interpolation_nodes),
                    least = in_pairs ? 4 : 3;
  return {std::min(all, std::max(least, in_pairs ? down - down % 2 : down)), all};
}

} // namespace ionskin::mechanics
