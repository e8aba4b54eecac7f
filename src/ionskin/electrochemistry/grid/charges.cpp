// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/grid/charges.hpp"

namespace ionskin::electrochemistry {
double ramo_weight(const ScaledGrid& grid, std::size_t level) {
  double weight = charge_weights(grid, level).here * grid.position[level];
  if (level > 0) {
    weight += charge_weights(grid, level - 1).above * grid.position[level - 1];
  }
  if (level + 1 < grid.levels) {
    weight += charge_weights(grid, level + 1).below * grid.position[level + 1];
  }
  return weight;
}

void wall_charges(const ScaledGrid& grid, const IonState& state,
                  std::span<const double> fixed_charge, WallCharges& charges) {
  const std::size_t columns = grid.columns(), top = grid.nodes() - columns;
  const auto c = state.concentration(), phi = state.potential();
  const ChargeWeights at_bottom = charge_weights(grid, 0);
  const ChargeWeights at_top = charge_weights(grid, grid.levels - 1);
  charges.bottom.resize(columns);
  charges.top.resize(columns);
  charges.total_bottom = charges.total_top = 0.0;
  const auto sideways = [&](std::span<const double> wall, std::size_t i) {
    const std::size_t x = i % grid.columns_x, y = i / grid.columns_x;
    double inflow = 0.0;
    const auto from = [&](bool exists, double coupling, std::size_t other) {
      inflow += exists ? coupling * (wall[other] - wall[i]) : 0.0;
    };
    from(x > 0, grid.coupling_x, i - 1);
    from(x + 1 < grid.columns_x, grid.coupling_x, i + 1);
    from(y > 0, grid.coupling_y, i - grid.columns_x);
    from(y + 1 < grid.columns_y, grid.coupling_y, i + grid.columns_x);
    return inflow;
  };
  for (std::size_t i = 0; i < columns; ++i) {
    const std::size_t bottom_node = i, top_node = top + i;
    charges.bottom[i] =
        (phi[bottom_node] - phi[bottom_node + columns]) / grid.spacing.front() -
        at_bottom.here * (c[bottom_node] - 1.0) -
        at_bottom.above * (c[bottom_node + columns] - 1.0) +
        grid.height.front() * (fixed_charge[bottom_node] - 1.0 - sideways(phi.first(columns), i));
    charges.top[i] =
        (phi[top_node] - phi[top_node - columns]) / grid.spacing.back() -
        at_top.here * (c[top_node] - 1.0) - at_top.below * (c[top_node - columns] - 1.0) +
        grid.height.back() * (fixed_charge[top_node] - 1.0 - sideways(phi.last(columns), i));
    charges.total_bottom += charges.bottom[i];
    charges.total_top += charges.top[i];
  }
}

double ramo_charge_top(const ScaledGrid& grid, const IonState& state,
                       std::span<const double> fixed_charge) {
  const std::size_t columns = grid.columns();
  const auto c = state.concentration(), phi = state.potential();
  const std::size_t top = grid.nodes() - columns;
  double total = 0.0;
  for (std::size_t k = 0; k < grid.levels; ++k) {
    const double fixed_weight = grid.position[k] * grid.height[k], weight = ramo_weight(grid, k);
    double sum = 0.0;
    for (std::size_t i = k * columns; i < (k + 1) * columns; ++i) {
      sum += fixed_weight * (fixed_charge[i] - 1.0) - weight * (c[i] - 1.0);
    }
    total += sum;
  }
  for (std::size_t i = 0; i < columns; ++i) {
    total += (phi[top + i] - phi[i]) / grid.thickness;
  }
  return total;
}

} // namespace ionskin::electrochemistry
