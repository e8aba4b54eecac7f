// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/equations/space_charge.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/electrochemistry/coupling/driving_channel.hpp"
#include "ionskin/electrochemistry/grid/derived_scales.hpp"
#include "ionskin/electrochemistry/grid/transport_grid.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numeric>

namespace ionskin::electrochemistry {
namespace {

double column_centre(const std::vector<double>& edges, std::size_t column) {
  return 0.5 * (edges[column] + edges[column + 1]);
}

/// Finds the first node whose value equals `extreme` but for rounding, by which nodes that mirror
/// each other differ.
std::size_t first_at(const std::vector<double>& values, double extreme) {
  const auto first = std::ranges::find_if(values, [extreme](double value) {
    return value == extreme || std::abs(value - extreme) <= 1e-9 * std::abs(extreme);
  });
  return static_cast<std::size_t>(first - values.begin());
}

} // namespace

FixedCharge::FixedCharge(const Case& input, const history::CoreHistory& history,
                         const TransportGrid& grid, const ScaledGrid& scaled)
    : coupling_(input.coupling), traits_(laws::coupling_law(input.coupling.law).traits),
      law_(laws::coupling_law(input.coupling.law)
               .with(input.coupling.coefficient, input.coupling.parameters)),
      reference_concentration_(input.electrochemistry.fixed_charge_concentration),
      resting_concentration_(input.electrochemistry.resting_concentration()),
      excess_(steric_excess(input.electrochemistry)), grid_(grid), scaled_(scaled),
      shear_(scaled.nodes(), 0.0), ratio_(scaled.nodes(), 1.0) {
  if (const history::HistoryChannel* shear = history.find(history::channel_name::shear)) {
    projection_.emplace(history, *shear, grid.x_edges, grid.y_edges,
                        history::hat_averages(history.grid.z_nodes, grid.z_nodes));
    largest_coupling_ = std::abs(coupling_.coefficient) * largest_magnitude(*shear);
  }
  if (traits_.moves_water) {
    water_.emplace(input, history, driving_channel(input.coupling.law, history), grid.x_edges,
                   grid.y_edges, grid.z_nodes);
    largest_coupling_ = water_->largest();
  }
}

void FixedCharge::start(double time) {
  if (water_) {
    water_->start(time);
  }
}

std::vector<double> FixedCharge::net_of_columns() const {
  const std::size_t columns = scaled_.columns();
  std::vector<double> net(columns, 0.0);
  if (traits_.makes_net_charge) {
    for (std::size_t i = 0; i < scaled_.nodes(); ++i) {
      net[i % columns] += 0.5 * scaled_.height[i / columns] * (ratio_[i] - 1.0);
    }
  }
  return net;
}

void FixedCharge::accept(std::span<const double> concentration) {
  if (!water_) {
    return;
  }
  const double amount_unit = resting_concentration_ * scaled_.unit; // [mol/m2]
  cations_.resize(scaled_.levels);
  for (std::size_t k = 0; k < scaled_.levels; ++k) {
    const auto level = concentration.subspan(k * scaled_.columns(), scaled_.columns());
    const double sum =
        std::accumulate(level.begin(), level.end(), 0.0,
                        [](double so_far, double value) { return so_far + (value - 1.0); });
    cations_[k] = amount_unit * scaled_.height[k] * sum / static_cast<double>(level.size());
  }
  water_->accept(cations_);
}

std::optional<poroelasticity::WaterState> FixedCharge::memory() const {
  return water_ ? std::optional(water_->state()) : std::nullopt;
}

void FixedCharge::restore(const std::optional<poroelasticity::WaterState>& memory) {
  if (water_) {
    water_->restore(memory.value_or(poroelasticity::WaterState{}));
  }
}

void FixedCharge::evaluate(double time) {
  if (projection_) {
    projection_->evaluate(time, shear_);
  }
  if (water_) {
    drive_ = water_->evaluate(time);
  }
  if (!law_) {
    return;
  }
  law_({scaled_.columns(), scaled_.levels, scaled_.height, scaled_.volume}, shear_, ratio_);
  check_sign(time);
  check_room(time);
}

void FixedCharge::check_sign(double time) const {
  const double* ratio = ratio_.data();
  double smallest = 0.0;
#pragma omp simd reduction(min : smallest)
  for (std::size_t i = 0; i < ratio_.size(); ++i) {
    smallest = std::min(smallest, ratio[i]);
  }
  if (smallest == 0.0) {
    return;
  }
  throw SolverError(
      fmt::format("the fixed charge concentration becomes negative: {}",
                  describe(first_at(ratio_, smallest), time)),
      fmt::format("make coupling.coefficient smaller in magnitude (now {:.4g}), or the shear: "
                  "fixed charge cannot reach below zero",
                  coupling_.coefficient));
}

void FixedCharge::check_room(double time) const {
  if (!excess_ || !releases_ions()) {
    return;
  }
  const double largest = std::ranges::max(ratio_);
  if (excess_->room(largest) > 0.0) {
    return;
  }
  throw SolverError(
      fmt::format("the law \"{}\" releases more cations than there is room for, with a fixed "
                  "charge of {}",
                  coupling_.law, describe(first_at(ratio_, largest), time)),
      fmt::format("make coupling.coefficient smaller in magnitude (now {:.4g}), or "
                  "electrochemistry.largest_concentration larger",
                  coupling_.coefficient));
}

std::string FixedCharge::describe(std::size_t node, double time) const {
  const std::size_t column = node % scaled_.columns();
  const double x = column_centre(grid_.x_edges, column % scaled_.columns_x);
  const double y = column_centre(grid_.y_edges, column / scaled_.columns_x);
  const double z = grid_.z_nodes[node / scaled_.columns()];
  return fmt::format("{:.4g} mol/m3 at t = {:.6g} s, x = {:.4g} mm, y = {:.4g} mm, {:.4g} um above "
                     "the bottom of the core, where the shear is {:.4g}",
                     ratio_[node] * reference_concentration_, time, x * 1e3, y * 1e3, z * 1e6,
                     shear_[node]);
}

void check_fixed_charge(const Case& input, const history::CoreHistory& history) {
  const TransportGrid grid = make_transport_grid(input, history);
  const DerivedScales scales = derive_scales(input.electrochemistry, history.core_thickness());
  const ScaledGrid scaled = scale_grid(grid, scales.debye_length, scales.area_ratio);
  FixedCharge charge(input, history, grid, scaled);
  charge.start(history.time.front());
  for (const double time : history.time) {
    charge.evaluate(time);
  }
}

} // namespace ionskin::electrochemistry
