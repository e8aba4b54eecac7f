// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/position/interpolation_nodes.hpp"

#include <algorithm>
#include <cmath>

namespace ionskin::mechanics {

std::vector<double> interpolation_nodes(double stroke, std::size_t count) {
  // Distances of the pairs from the middle, over half the stroke. Found by search for the smallest
  // Lebesgue constants of 4, 8, 12 and 16 nodes: 1.9, 2.0, 4.7 and 7.0 (4.0, 4.4 and 8.3 between).
  constexpr std::array<double, most_interpolation_nodes / 2> pairs{1,    0.55, 0.21, 0.85,
                                                                   0.95, 0.40, 0.76, 0.08};
  std::vector<double> nodes;
  for (std::size_t pair = 0; pair < count / 2; ++pair) {
    nodes.push_back(stroke * (1 - pairs[pair]) / 2);
    nodes.push_back(stroke * (1 + pairs[pair]) / 2);
  }
  if (count % 2 == 1) {
    nodes.push_back(stroke / 2);
  }
  std::sort(nodes.begin(), nodes.end());
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

std::size_t expected_node_count(const Case& input, const std::array<double, 2>& from,
                                const std::array<double, 2>& to) {
  // The error falls by the decay with each node. On cases/paper.toml, over two fifths of the skin,
  // by 0.24; eight nodes reach the tolerance of coarse and standard there, ten that of fine.
  constexpr double usual_decay = 0.24, usual_share = 0.4;
  const double usual_count = input.numerics.preset == Preset::fine ? 10 : 8;
  const double dx = std::abs(to[0] - from[0]), dy = std::abs(to[1] - from[1]);
  const double way = std::hypot(dx, dy);
  const double extent = (dx * input.skin.length + dy * input.skin.width) / way;
  const double share = std::min(1.0, way / extent / usual_share);
  const double count = usual_count * std::log(usual_decay) / std::log(usual_decay * share);
  // Every run that shares positions pays for each of them. Over a narrow rectangle two lines may
  // do; the error of the strain between them tells.
  constexpr double narrow_count = 4;
  if (input.numerics.shared.given() && count < narrow_count) {
    return 2;
  }
  // Lengths are differences of coordinates: their rounding must not cost a pair.
  const double pairs = std::ceil(count / 2 - 1e-9);
  return 2 * std::max<std::size_t>(1, static_cast<std::size_t>(pairs));
}

} // namespace ionskin::mechanics
