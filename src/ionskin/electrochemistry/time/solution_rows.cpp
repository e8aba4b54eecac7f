// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/time/solution_rows.hpp"

#include "ionskin/electrochemistry/equations/exact_average.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace ionskin::electrochemistry {
namespace {

double column_area(const TransportGrid& grid) {
  return (grid.x_edges.back() - grid.x_edges.front()) *
         (grid.y_edges.back() - grid.y_edges.front()) /
         static_cast<double>((grid.x_edges.size() - 1) * (grid.y_edges.size() - 1));
}

/// Finds the member of `times` nearest to an instant.
double nearest(const std::vector<double>& times, double instant) {
  return *std::min_element(times.begin(), times.end(), [instant](double a, double b) {
    return std::abs(a - instant) < std::abs(b - instant);
  });
}

/// Mean voltage of the top face against the bottom one [R T/(v F)].
double mean_voltage(const IonState& state, std::size_t columns) {
  const auto bottom = state.potential().first(columns), top = state.potential().last(columns);
  const double first = bottom.front(), last = top.back();
  double departures = 0.0;
  for (std::size_t i = 0; i < columns; ++i) {
    departures += (top[i] - last) - (bottom[i] - first);
  }
  return last - first + departures / static_cast<double>(columns);
}

/// Largest difference in potential along the metal of either electrode [R T/(v F)].
double metal_drop(const IonState& state, std::size_t columns) {
  const auto [low_b, high_b] = std::ranges::minmax(state.potential().first(columns));
  const auto [low_t, high_t] = std::ranges::minmax(state.potential().last(columns));
  return std::max(high_b - low_b, high_t - low_t);
}

std::vector<double> scaled_copy(std::span<const double> values, double unit) {
  std::vector<double> copy(values.begin(), values.end());
  for (double& value : copy) {
    value *= unit;
  }
  return copy;
}

} // namespace

SolutionRows::SolutionRows(const Case& input, const DerivedScales& scales,
                           const TransportGrid& grid, const MidWidthMirror& mirror,
                           const ScaledGrid& scaled, const FixedCharge& fixed_charge,
                           const std::vector<double>& landings,
                           const std::vector<double>& snapshot_times, const CutElectrode* cut)
    : mirror_(mirror), scaled_(scaled), fixed_charge_(fixed_charge),
      charge_unit_(scales.charge_density * column_area(grid)),
      mean_unit_(mirror.copies() * static_cast<double>(scaled.columns()) * charge_unit_),
      area_(input.skin.length * input.skin.width), time_unit_(scales.relaxation_time),
      volume_unit_(scales.debye_length * column_area(grid)),
      concentration_unit_(input.electrochemistry.fixed_charge_concentration /
                          input.electrochemistry.valence),
      potential_unit_(scales.potential_scale),
      segments_(make_electrode_segments(input.readout.taxels, grid)), cut_(cut),
      is_own_(segments_.names.size(), false) {
  for (std::size_t i = 0; i < input.readout.taxels.size(); ++i) {
    is_own_[i] = input.readout.has_own_circuit(i);
    row_of_taxel_.push_back(input.readout.scan_row(i));
  }
  for (const std::vector<double>& share : segments_.share) {
    segment_area_.push_back(std::accumulate(share.begin(), share.end(), 0.0));
  }
  for (const Taxel& line : input.readout.lines()) {
    line_names_.push_back(line.name);
  }
  for (const double instant : snapshot_times) {
    snapshot_times_.push_back(nearest(landings, instant));
  }
}

void SolutionRows::append(double time, const IonState& state, const ElectrodeReading& electrodes,
                          std::optional<std::size_t> row, IonSolution& solution) {
  wall_charges(scaled_, state, fixed_charge_.ratio(), charges_);
  mirror_.complete(charges_);
  const auto c = state.concentration();
  const auto [low, high] = std::ranges::minmax(state.potential());
  solution.time.push_back(time);
  solution.charge_top.push_back(charge_unit_ * charges_.total_top);
  solution.charge_bottom.push_back(charge_unit_ * charges_.total_bottom);
  append_segments(segments_, charges_, charge_unit_, solution);
  append_conductors(electrodes.rows, row, solution);
  if (const poroelasticity::StreamingDrive* water = fixed_charge_.water()) {
    append_water(*water, area_, solution.water);
  }
  solution.ramo_charge_top.push_back(mirror_.copies() * charge_unit_ *
                                     ramo_charge_top(scaled_, state, fixed_charge_.ratio()));
  solution.relaxation_charge.push_back(mean_unit_ * electrodes.relaxation.charge);
  solution.relaxation_current.push_back(mean_unit_ / time_unit_ * electrodes.relaxation.rate);
  solution.voltage.push_back(
      potential_unit_ * electrodes.lead_voltage.value_or(mean_voltage(state, scaled_.columns())));
  if (electrodes.lead_voltage) {
    solution.metal_drop.push_back(potential_unit_ * metal_drop(state, scaled_.columns()));
  }
  solution.ion_amount.push_back(mirror_.copies() * volume_unit_ * concentration_unit_ *
                                ExactAverage::total(scaled_, c));
  solution.min_concentration.push_back(concentration_unit_ * std::ranges::min(c));
  solution.max_potential.push_back(potential_unit_ * std::max(high, -low));
  solution.shear_integral.push_back(mirror_.copies() * volume_unit_ *
                                    ExactAverage::total(scaled_, fixed_charge_.shear()));
  if (std::ranges::find(snapshot_times_, time) != snapshot_times_.end()) {
    solution.snapshots.push_back(snapshot(time, state));
  }
}

namespace {

/// Appends the charge that has come to a taxel: to `passed` while the taxel is read, else to
/// `bypassed`.
void add_passed(double charge, bool is_read, SegmentCharge& segment) {
  const double bypassed = segment.bypassed.empty() ? 0.0 : segment.bypassed.back();
  const double passed = segment.passed.empty() ? 0.0 : segment.passed.back();
  segment.passed.push_back(is_read ? charge - bypassed : passed);
  segment.bypassed.push_back(is_read ? bypassed : charge - passed);
}

} // namespace

void SolutionRows::append_conductors(const std::vector<ElectrodeRow>& electrodes,
                                     std::optional<std::size_t> read, IonSolution& solution) const {
  if (cut_ == nullptr) {
    return;
  }
  if (!cut_->row_of_segment.empty()) {
    append_lines(electrodes.empty() ? held_lines() : electrodes, read, solution);
    return;
  }
  if (electrodes.empty()) {
    append_held(read, solution);
    return;
  }
  for (std::size_t i = 0; i < segments_.names.size(); ++i) {
    SegmentCharge& segment = solution.top_segments[i];
    const std::size_t conductor = cut_->conductor_of_segment[i];
    const ElectrodeRow& row = electrodes[conductor];
    segment.voltage.push_back(potential_unit_ * row.potential);
    if (is_own_[i]) {
      const double unit = charge_unit_ * cut_->copies[conductor];
      segment.charge.back() = unit * row.charge;
      add_passed(unit * row.passed, !read || *read == row_of_taxel_[i], segment);
    }
  }
  give_rest(solution);
}

void SolutionRows::give_rest(IonSolution& solution) const {
  double left = solution.charge_top.back(), area = 0.0;
  for (std::size_t i = 0; i < is_own_.size(); ++i) {
    left -= solution.top_segments[i].charge.back();
    area += is_own_[i] ? 0.0 : segment_area_[i];
  }
  for (std::size_t i = 0; i < is_own_.size() && area > 0.0; ++i) {
    solution.top_segments[i].charge.back() += is_own_[i] ? 0.0 : left * segment_area_[i] / area;
  }
}

void SolutionRows::append_held(std::optional<std::size_t> read, IonSolution& solution) const {
  const std::vector<double> below =
      segments_.charges(mirror_.whole(fixed_charge_.net_of_columns()));
  for (std::size_t i = 0; i < segments_.names.size(); ++i) {
    SegmentCharge& segment = solution.top_segments[i];
    segment.voltage.push_back(0.0);
    if (is_own_[i]) {
      add_passed(segment.charge.back() - charge_unit_ * below[i],
                 !read || *read == row_of_taxel_[i], segment);
    }
  }
}

std::vector<ElectrodeRow> SolutionRows::held_lines() const {
  std::vector<double> walls = charges_.bottom;
  walls.insert(walls.end(), charges_.top.begin(), charges_.top.end());
  const std::vector<double> charge = cut_->conductors.sums(walls),
                            net = cut_->conductors.sums(
                                mirror_.whole(fixed_charge_.net_of_columns()));
  std::vector<ElectrodeRow> lines;
  for (std::size_t e = 0; e < charge.size(); ++e) {
    lines.push_back({0.0, charge[e], charge[e] - net[e]});
  }
  return lines;
}

void SolutionRows::append_lines(const std::vector<ElectrodeRow>& lines,
                                std::optional<std::size_t> read, IonSolution& solution) const {
  solution.lines.resize(lines.size());
  for (std::size_t e = 0; e < lines.size(); ++e) {
    SegmentCharge& line = solution.lines[e];
    line.name = line_names_[e];
    line.charge.push_back(charge_unit_ * lines[e].charge);
    line.voltage.push_back(potential_unit_ * lines[e].potential);
    line.passed.push_back(charge_unit_ * lines[e].passed);
  }
  for (std::size_t i = 0; i < segments_.names.size(); ++i) {
    SegmentCharge& crossing = solution.top_segments[i];
    const ElectrodeRow& column = lines[cut_->conductor_of_segment[i]];
    const ElectrodeRow& row = lines[cut_->row_of_segment[i]];
    crossing.voltage.push_back(potential_unit_ * (column.potential - row.potential));
    if (read) {
      add_passed(charge_unit_ * column.passed, *read == row_of_taxel_[i], crossing);
    }
  }
}

void append_segments(const ElectrodeSegments& segments, const WallCharges& charges, double unit,
                     IonSolution& solution) {
  const std::vector<double> top = segments.charges(charges.top);
  const std::vector<double> bottom = segments.charges(charges.bottom);
  solution.top_segments.resize(top.size());
  for (std::size_t i = 0; i < top.size(); ++i) {
    solution.top_segments[i].name = segments.names[i];
    solution.top_segments[i].charge.push_back(unit * top[i]);
    solution.top_segments[i].bottom_charge.push_back(unit * bottom[i]);
  }
}

void append_water(const poroelasticity::StreamingDrive& water, double area, WaterRows& rows) {
  rows.pressure_top.push_back(water.pressure_at_top());
  rows.pressure_bottom.push_back(water.pressure_at_bottom());
  rows.streaming_voltage.push_back(water.streaming_voltage());
  rows.dilution_voltage.push_back(water.dilution_voltage());
  rows.largest_pressure.push_back(water.largest_pressure());
  rows.largest_drive.push_back(water.largest_drive());
  const poroelasticity::Outflow left = water.left(), dragged = water.dragged();
  rows.outflow_top.push_back(area * left.top);
  rows.outflow_bottom.push_back(area * left.bottom);
  rows.dragged_top.push_back(area * dragged.top);
  rows.dragged_bottom.push_back(area * dragged.bottom);
  rows.dragged_difference.push_back(water.dragged_pressure_difference());
  rows.holding_pressure.push_back(water.holding_pressure());
}

void SolutionRows::finish(const IonState& state, IonSolution& solution) {
  wall_charges(scaled_, state, fixed_charge_.ratio(), charges_);
  mirror_.complete(charges_);
  solution.column_charge_top = scaled_copy(charges_.top, charge_unit_);
}

IonSnapshot SolutionRows::snapshot(double time, const IonState& state) const {
  IonSnapshot snapshot{time,
                       scaled_copy(mirror_.whole(state.concentration()), concentration_unit_),
                       scaled_copy(mirror_.whole(state.potential()), potential_unit_),
                       mirror_.whole(fixed_charge_.shear()),
                       {},
                       {}};
  if (const poroelasticity::StreamingDrive* water = fixed_charge_.water()) {
    snapshot.pore_pressure = mirror_.whole(water->pressure_at_levels());
    snapshot.swelling = mirror_.whole(water->swelling_at_levels());
  }
  return snapshot;
}

} // namespace ionskin::electrochemistry
