// SPDX-License-Identifier: Apache-2.0
#include "ionskin/poroelasticity/dragged_water.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace ionskin::poroelasticity {
namespace {

Relaxation of_water(Relaxation relaxation) {
  relaxation.load = RelaxingLoad::water;
  return relaxation;
}

} // namespace

Outflow outflow(const std::vector<double>& nodes, const WaterWalls& walls,
                std::span<const double> growth) {
  Outflow out;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const double top = walls.share_of_top(nodes[i], nodes.back());
    out.top -= top * growth[i];
    out.bottom -= walls.bottom == sealed_wall ? 0.0 : (1.0 - top) * growth[i];
  }
  return out;
}

DraggedWater::DraggedWater(const WaterProperties& water, double volume, std::vector<double> nodes,
                           const WaterWalls& walls, const std::vector<double>& levels,
                           const Relaxation& relaxation)
    : volume_(volume), modulus_(water.consolidation_coefficient / water.mobility),
      held_share_(water.held_share), nodes_(nodes), lengths_(node_lengths(nodes)), walls_(walls),
      to_levels_(quadratic_interpolation(nodes, levels)),
      water_({1, 1}, {1.0, 1.0}, std::move(nodes), walls, water.consolidation_coefficient,
             water.held_share, of_water(relaxation)),
      relaxes_(relaxation.terms() > 1), brought_(nodes_.size(), 0.0), load_(nodes_.size(), 0.0),
      pressure_(nodes_.size(), 0.0) {}

PressureState DraggedWater::rest() const {
  return {std::vector<double>(water_.amplitudes(), 0.0), std::vector<double>(nodes_.size(), 0.0)};
}

void DraggedWater::step(const PressureState& begin, double duration,
                        std::span<const double> cations, PressureState& end) {
  // The water of each z level is distributed to the nodes of its element by the shape functions,
  // which keeps its total and its first moment.
  std::ranges::fill(brought_, 0.0);
  for (std::size_t k = 0; k < cations.size(); ++k) {
    for (std::size_t j = 0; j < to_levels_.weights[k].size(); ++j) {
      brought_[to_levels_.first[k] + j] += to_levels_.weights[k][j] * volume_ * cations[k];
    }
  }
  for (std::size_t i = 0; i < load_.size(); ++i) {
    load_[i] = modulus_ * brought_[i] / lengths_[i];
  }
  water_.step(begin, duration, load_, end);
  water_.pressure(end, pressure_);
  // Increase of the water at each node: water stored by P minus water brought by the cations.
  if (relaxes_) {
    water_.undrained(end, load_);
    for (std::size_t i = 0; i < load_.size(); ++i) {
      load_[i] = lengths_[i] * (pressure_[i] - load_[i]) / modulus_;
    }
    left_ = outflow(nodes_, walls_, load_);
    return;
  }
  const double back = held_share_ *
                      std::inner_product(lengths_.begin(), lengths_.end(), pressure_.begin(), 0.0) /
                      nodes_.back();
  for (std::size_t i = 0; i < load_.size(); ++i) {
    load_[i] = lengths_[i] * (pressure_[i] - back) / modulus_ - brought_[i];
  }
  left_ = outflow(nodes_, walls_, load_);
}

} // namespace ionskin::poroelasticity
