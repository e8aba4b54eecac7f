// SPDX-License-Identifier: Apache-2.0
#include "ionskin/poroelasticity/streaming_drive.hpp"

#include "ionskin/base/constants.hpp"
#include "ionskin/base/error.hpp"
#include "ionskin/base/largest.hpp"

#include <cmath>
#include <numeric>

namespace ionskin::poroelasticity {
namespace {

using history::CoreHistory;
using history::HistoryChannel;

/// Number of quadratic elements through the core: with 12, the relative error of a pressure
/// difference is 2e-5 (tests of `PorePressure`).
constexpr std::size_t elements_through_core = 12;

double mean(std::span<const double> values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double width_of(const std::vector<double>& edges) {
  return (edges.back() - edges.front()) / static_cast<double>(edges.size() - 1);
}

} // namespace

StreamingDrive::StreamingDrive(const Case& input, const CoreHistory& history,
                               const HistoryChannel& channel, const std::vector<double>& x_edges,
                               const std::vector<double>& y_edges,
                               const std::vector<double>& levels)
    : water_(derive_water_properties(input)), relaxation_(derive_relaxation(input)),
      pressure_of_channel_(channel.name == history::channel_name::dilation ? water_.storage_modulus
                                                                           : 1.0),
      pore_pressure_({x_edges.size() - 1, y_edges.size() - 1},
                     {width_of(x_edges), width_of(y_edges)},
                     wall_clustered_nodes(history.core_thickness(), elements_through_core),
                     water_walls(input.water, water_.mobility), water_.consolidation_coefficient,
                     water_.held_share, relaxation_),
      projection_(history, channel, x_edges, y_edges,
                  history::linear_interpolation(history.grid.z_nodes, pore_pressure_.nodes())),
      to_levels_(quadratic_interpolation(pore_pressure_.nodes(), levels)),
      walls_(water_walls(input.water, water_.mobility)), outside_(input, walls_, water_.mobility),
      passed_before_(outside_.passed(history.time.front())),
      dragged_water_(water_, input.water.drag_number * constants::molar_volume_of_water,
                     pore_pressure_.nodes(), walls_, levels, relaxation_),
      streaming_(input.electrochemistry.valence * water_.streaming_coefficient /
                 water_.thermal_voltage),
      dilution_(water_.dilution / water_.drained_modulus),
      volts_(water_.thermal_voltage / input.electrochemistry.valence),
      largest_(streaming_ *
               (pressure_of_channel_ * largest_magnitude(channel) + outside_.largest())) {}

void StreamingDrive::load(double time) {
  projection_.evaluate(time, undrained_);
  for (double& value : undrained_) {
    value *= pressure_of_channel_;
  }
  driving_ = undrained_;
  for (std::size_t i = 0; outside_.acts() && i < driving_.size(); ++i) {
    driving_[i] -= outside_.steady(nodes()[i / columns()], time);
  }
}

void StreamingDrive::unload(double time) {
  for (std::size_t i = 0; outside_.acts() && i < pressure_.size(); ++i) {
    pressure_[i] += outside_.steady(nodes()[i / columns()], time);
  }
  if (relaxation_.terms() > 1) {
    pore_pressure_.undrained(tried_.pressure, undrained_);
  }
  if (water_.held_share > 0) {
    const double back = water_.held_share * mean_pressure();
    for (double& value : undrained_) {
      value += back;
    }
  }
}

double StreamingDrive::mean_pressure() const {
  const std::vector<double> lengths = node_lengths(nodes());
  double sum = 0;
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    sum += lengths[i] * mean(pressure().subspan(i * columns(), columns()));
  }
  return sum / nodes().back();
}

void StreamingDrive::start(double time) {
  load(time);
  accepted_.time = time;
  pore_pressure_.start(driving_, accepted_.pressure);
  accepted_.dragged = dragged_water_.rest();
}

void StreamingDrive::restore(const WaterState& state) {
  const std::size_t nodes = pore_pressure_.nodes().size();
  if (state.pressure.pressure.size() != pore_pressure_.amplitudes() ||
      state.pressure.undrained.size() != pore_pressure_.values() ||
      state.dragged.pressure.size() != nodes * relaxation_.terms() ||
      state.dragged.undrained.size() != nodes) {
    throw UserError("the saved state of the water belongs to another case: its grid differs; "
                    "remove it to start afresh");
  }
  accepted_ = state;
}

const std::vector<double>& StreamingDrive::evaluate(double time) {
  load(time);
  tried_.time = time;
  pore_pressure_.step(accepted_.pressure, time - accepted_.time, driving_, tried_.pressure);
  pore_pressure_.pressure(tried_.pressure, pressure_);
  unload(time);
  combine();
  return at_levels_;
}

void StreamingDrive::accept(std::span<const double> cations) {
  dragged_water_.step(accepted_.dragged, tried_.time - accepted_.time, cations, tried_.dragged);
  accepted_ = tried_;
}

void StreamingDrive::combine() {
  drive_.resize(pressure_.size());
  for (std::size_t i = 0; i < drive_.size(); ++i) {
    drive_[i] = streaming_ * pressure_[i] - dilution_ * (pressure_[i] - undrained_[i]);
  }
  history::apply_along(to_levels_, 1, drive_.size() / pore_pressure_.nodes().size(), drive_,
                       at_levels_);
}

double StreamingDrive::holding_pressure() const {
  return water_.held_share > 0 ? mean(undrained_) / water_.held_share : 0.0;
}

double StreamingDrive::pressure_at_bottom() const {
  return mean(std::span(pressure_).first(columns()));
}

double StreamingDrive::pressure_at_top() const {
  return mean(std::span(pressure_).last(columns()));
}

double StreamingDrive::wall_difference(const std::vector<double>& field) const {
  return mean(std::span(field).last(columns())) - mean(std::span(field).first(columns()));
}

double StreamingDrive::streaming_voltage() const {
  return -volts_ * streaming_ * wall_difference(pressure_);
}

double StreamingDrive::dilution_voltage() const {
  return volts_ * dilution_ * (wall_difference(pressure_) - wall_difference(undrained_));
}

Outflow StreamingDrive::left() const {
  const double modulus = water_.consolidation_coefficient / water_.mobility;
  std::vector<double> growth = node_lengths(nodes());
  for (std::size_t i = 0; i < growth.size(); ++i) {
    const std::size_t begin = i * columns();
    growth[i] *=
        (mean(pressure().subspan(begin, columns())) - mean(undrained().subspan(begin, columns()))) /
        modulus;
  }
  const Outflow by_load = outflow(nodes(), walls_, growth);
  const double passed = outside_.passed(tried_.time) - passed_before_;
  return {by_load.bottom + dragged().bottom - passed, by_load.top + dragged().top + passed};
}

std::vector<double> StreamingDrive::pressure_at_levels() const {
  std::vector<double> levels;
  history::apply_along(to_levels_, 1, columns(), pressure_, levels);
  return levels;
}

std::vector<double> StreamingDrive::swelling_at_levels() const {
  std::vector<double> swelling(pressure_.size()), levels;
  for (std::size_t i = 0; i < swelling.size(); ++i) {
    swelling[i] = (pressure_[i] - undrained_[i]) / water_.drained_modulus;
  }
  history::apply_along(to_levels_, 1, columns(), swelling, levels);
  return levels;
}

double StreamingDrive::largest_pressure() const {
  return base::largest_magnitude(pressure_);
}

double StreamingDrive::largest_drive() const {
  return base::largest_magnitude(drive_);
}

} // namespace ionskin::poroelasticity
