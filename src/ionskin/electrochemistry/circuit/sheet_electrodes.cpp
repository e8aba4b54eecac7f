// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/circuit/sheet_electrodes.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace ionskin::electrochemistry {
namespace {

/// Largest conductance between neighbouring columns, in the unit of the solver: beyond, differences
/// in potential along the metal are lost in rounding.
constexpr double most_conductance = 1e7;

/// Implicit part of a step for which only Poisson's equation is solved [relaxation times].
constexpr double instant_step = 1e-6;

/// Rows of columns along y that a lead between 0 and `reach` [m] touches, and the touched share of
/// their widths.
SheetElectrodes::Contact rows_up_to(const std::vector<double>& edges, double reach) {
  SheetElectrodes::Contact contact;
  for (std::size_t j = 0; j + 1 < edges.size() && edges[j] < reach; ++j) {
    contact.columns_y.push_back(j);
    contact.share_y.push_back(std::min(1.0, (reach - edges[j]) / (edges[j + 1] - edges[j])));
  }
  return contact;
}

} // namespace

SheetElectrodes::SheetElectrodes(const ScaledGrid& grid, std::array<double, 2> conductance,
                                 Contact contact, std::optional<ScaledAdmittance> admittance)
    : grid_(grid), conductance_(conductance), contact_(std::move(contact)),
      admittance_(admittance) {
  for (std::size_t j = 0; j < contact_.columns_y.size(); ++j) {
    for (const std::size_t x : contact_.columns_x) {
      touched_.push_back(contact_.columns_y[j] * grid.columns_x + x);
      touched_share_.push_back(2.0 * grid.coupling_x * contact_.share_y[j]);
    }
  }
  total_share_ = std::accumulate(touched_share_.begin(), touched_share_.end(), 0.0);
}

std::vector<double> SheetElectrodes::contact_conductance(std::size_t wall) const {
  std::vector<double> result = touched_share_;
  for (double& value : result) {
    value *= conductance_[wall];
  }
  return result;
}

double SheetElectrodes::total_contact(std::size_t wall) const {
  return conductance_[wall] * total_share_;
}

double SheetElectrodes::implicit_step(double step) {
  return std::max(step, instant_step);
}

double SheetElectrodes::circuit_conductance(double step) const {
  return admittance_ ? step * admittance_->conductance + admittance_->capacitance : 0.0;
}

double SheetElectrodes::contact_mean(std::span<const double> top, double origin) const {
  double sum = 0.0;
  for (std::size_t i = 0; i < touched_.size(); ++i) {
    sum += touched_share_[i] * (top[touched_[i]] - origin);
  }
  return sum / total_share_;
}

// The charges that the columns start from and the charge that comes from the lead add up to the
// charge that the circuit leaves on the columns.
double SheetElectrodes::lead_potential(const SheetStage& stage, double potential_bottom,
                                       double potential_top, std::span<const double> top) const {
  if (!stage.circuit) {
    return potential_top;
  }
  const double columns = static_cast<double>(grid_.columns()),
               contact = stage.step * total_contact(top_wall);
  return potential_bottom + (columns * (stage.circuit->start - stage.passed) +
                             contact * contact_mean(top, potential_bottom)) /
                                (contact + columns * stage.circuit->conductance);
}

double SheetElectrodes::lead_change(const SheetStage& stage, std::span<const double> change) const {
  if (!stage.circuit) {
    return 0.0;
  }
  const double contact = stage.step * total_contact(top_wall);
  return contact * contact_mean(change, 0.0) /
         (contact + static_cast<double>(grid_.columns()) * stage.circuit->conductance);
}

void SheetElectrodes::take_inflow(std::size_t wall, double step, std::span<const double> potential,
                                  double lead, std::span<double> charge) const {
  const std::size_t columns_x = grid_.columns_x;
  const double along_x = step * conductance_[wall] * grid_.coupling_x,
               along_y = step * conductance_[wall] * grid_.coupling_y;
  const auto exchange = [&](std::size_t a, std::size_t b, double conductance) {
    const double flow = conductance * (potential[b] - potential[a]);
    charge[a] -= flow;
    charge[b] += flow;
  };
  for (std::size_t i = 0; i < potential.size(); ++i) {
    if ((i + 1) % columns_x != 0) {
      exchange(i, i + 1, along_x);
    }
    if (i + columns_x < potential.size()) {
      exchange(i, i + columns_x, along_y);
    }
  }
  for (std::size_t i = 0; i < touched_.size(); ++i) {
    charge[touched_[i]] -=
        step * conductance_[wall] * touched_share_[i] * (lead - potential[touched_[i]]);
  }
}

std::optional<SheetElectrodes> sheet_electrodes(const Case& input, const DerivedScales& scales,
                                                const MidWidthMirror& mirror,
                                                const ScaledGrid& scaled) {
  if (!input.has_sheet_resistance()) {
    return std::nullopt;
  }
  const std::array<double, 2> given = input.skin.sheet_resistances();
  std::array<double, 2> conductance{};
  for (std::size_t wall = 0; wall < 2; ++wall) {
    const double unit = scales.potential_scale * scales.relaxation_time /
                        (scales.charge_density * scales.debye_length * scales.debye_length);
    const double most = most_conductance / scaled.coupling_x;
    conductance[wall] = given[wall] > 0 ? std::min(unit / given[wall], most) : most;
  }
  const ElectrodeContact where = input.readout.contact;
  const std::vector<double>& edges = mirror.solved_grid().y_edges;
  SheetElectrodes::Contact contact = rows_up_to(
      edges, where == ElectrodeContact::corner ? corner_share * input.skin.width : edges.back());
  contact.columns_x = {0};
  if (where == ElectrodeContact::both_ends) {
    contact.columns_x.push_back(scaled.columns_x - 1);
  }
  return SheetElectrodes(
      scaled, conductance, std::move(contact),
      scaled_admittance(input.readout, scales, input.skin.length * input.skin.width));
}

} // namespace ionskin::electrochemistry
