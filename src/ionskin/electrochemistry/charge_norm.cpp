// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/charge_norm.hpp"

#include "ionskin/electrochemistry/charges.hpp"

#include <algorithm>
#include <cmath>

namespace ionskin::electrochemistry {

ChargeNorm::ChargeNorm(const ScaledGrid& grid)
    : grid_(grid), top_(grid.columns()), bottom_(grid.columns()) {
  for (std::size_t k = 0; k < grid.levels; ++k) {
    top_weight_.push_back(ramo_weight(grid, k));
    bottom_weight_.push_back(grid.height[k] - top_weight_.back());
  }
}

double ChargeNorm::of_change(std::span<const double> change, double column_share) {
  const std::size_t columns = grid_.columns();
  std::ranges::fill(top_, 0.0);
  std::ranges::fill(bottom_, 0.0);
  for (std::size_t k = 0; k < grid_.levels; ++k) {
    const double* level = change.data() + k * columns;
    const double to_top = top_weight_[k], to_bottom = bottom_weight_[k];
#pragma omp simd
    for (std::size_t i = 0; i < columns; ++i) {
      top_[i] += to_top * level[i];
      bottom_[i] += to_bottom * level[i];
    }
  }
  const auto count = static_cast<double>(columns);
  double mean = 0.0, differences = 0.0, sums = 0.0;
  for (std::size_t i = 0; i < columns; ++i) {
    const double difference = 0.5 * (top_[i] - bottom_[i]), sum = 0.5 * (top_[i] + bottom_[i]);
    mean += difference;
    differences += difference * difference;
    sums += sum * sum;
  }
  return std::max({std::abs(mean) / count, column_share * std::sqrt(differences / count),
                   0.2 * column_share * std::sqrt(sums / count)});
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
  const auto phi = state.potential();
  const double polarisation = mean - (phi.back() - phi.front()) / grid_.thickness;
  return std::max({std::abs(mean), std::abs(polarisation), 0.1 * std::sqrt(difference / columns),
                   0.01 * std::sqrt(all / columns)});
}

} // namespace ionskin::electrochemistry
