// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/solver/charge_norm.hpp"

#include "ionskin/base/largest.hpp"
#include "ionskin/electrochemistry/grid/charges.hpp"

#include <algorithm>
#include <cmath>

namespace ionskin::electrochemistry {

ChargeNorm::ChargeNorm(const ScaledGrid& grid) : grid_(grid) {
  auto& [to_top, to_bottom] = weights_;
  for (std::size_t k = 0; k < grid.levels; ++k) {
    to_top.push_back(ramo_weight(grid, k));
    to_bottom.push_back(grid.height[k] - to_top.back());
  }
}

double ChargeNorm::of_change(const std::array<std::vector<double>, 2>& charges,
                             double column_share) {
  const auto& [top, bottom] = charges;
  const auto count = static_cast<double>(top.size());
  double mean = 0.0, differences = 0.0, sums = 0.0;
  for (std::size_t i = 0; i < top.size(); ++i) {
    const double difference = 0.5 * (top[i] - bottom[i]), sum = 0.5 * (top[i] + bottom[i]);
    mean += difference;
    differences += difference * difference;
    sums += sum * sum;
  }
  return base::nan_max(std::abs(mean) / count,
                       base::nan_max(column_share * std::sqrt(differences / count),
                                     0.2 * column_share * std::sqrt(sums / count)));
}

double ChargeNorm::of_state(const IonState& state, std::span<const double> fixed_charge) const {
  WallCharges charges;
  wall_charges(grid_, state, fixed_charge, charges);
  const auto columns = static_cast<double>(grid_.columns());
  double all = 0.0, difference = 0.0;
  for (std::size_t i = 0; i < charges.top.size(); ++i) {
    const double top = charges.top[i], bottom = charges.bottom[i];
    all += 0.5 * (top * top + bottom * bottom);
    difference += 0.25 * (top - bottom) * (top - bottom);
  }
  const double mean = 0.5 * (charges.total_top - charges.total_bottom) / columns;
  double voltage = 0.0;
  const auto top_wall = state.potential().last(grid_.columns());
  for (std::size_t i = 0; i < grid_.columns(); ++i) {
    voltage += top_wall[i] - state.potential()[i];
  }
  const double polarisation = mean - voltage / (columns * grid_.thickness);
  return base::nan_max(
      base::nan_max(std::abs(mean), std::abs(polarisation)),
      base::nan_max(0.1 * std::sqrt(difference / columns), 0.01 * std::sqrt(all / columns)));
}

} // namespace ionskin::electrochemistry
