// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/electrochemistry/circuit/external_circuit.hpp"
#include "ionskin/electrochemistry/circuit/terminal_voltage.hpp"
#include "ionskin/electrochemistry/circuit/wall_electrodes.hpp"
#include "ionskin/electrochemistry/grid/derived_scales.hpp"
#include "ionskin/electrochemistry/grid/mid_width_mirror.hpp"
#include "ionskin/electrochemistry/grid/scaled_grid.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace ionskin::electrochemistry {

/// Equations that metal with a sheet resistance adds to one implicit stage, all scaled: the charge
/// per area of every column is what it starts from, plus `step` times what comes along the metal
/// and from the contact.
struct SheetStage {
  std::array<std::vector<double>, 2> start; ///< of the columns of the bottom and of the top wall
  /// Mean over the top wall of the start, without what returns through the ground.
  double passed = 0;
  double step = 0;
  std::optional<CircuitStage> circuit; ///< nothing where the potentials of both leads are given
};

/// Both electrodes as sheets of metal with leads at their ends: charge moves along them by their
/// sheet resistances, docs/model.md (67). A contact joins half a column's width of metal to a lead.
class SheetElectrodes {
public:
  /// Columns whose outer side a lead touches: all that are in one of `columns_x` and in one of
  /// `columns_y`, whose shares of the width are touched.
  struct Contact {
    std::vector<std::size_t> columns_x, columns_y;
    std::vector<double> share_y;
  };

  /// @param grid must outlive this
  /// @param conductance of a square of either metal in units of F c0 lambda^3 v F / (tau R T)
  /// @param admittance between the leads; nothing where their potentials are given
  SheetElectrodes(const ScaledGrid& grid, std::array<double, 2> conductance, Contact contact,
                  std::optional<ScaledAdmittance> admittance);

  double conductance(std::size_t wall) const { return conductance_[wall]; }
  const Contact& contact() const { return contact_; }
  const std::optional<ScaledAdmittance>& admittance() const { return admittance_; }
  /// Columns that the leads touch, row by row of `contact`, and the conductance to each.
  const std::vector<std::size_t>& touched() const { return touched_; }
  std::vector<double> contact_conductance(std::size_t wall) const;
  /// Conductance of the whole contact.
  double total_contact(std::size_t wall) const;

  /// Implicit part of a step for the metal. Where only Poisson's equation is asked, a time in which
  /// next to nothing moves fixes the potential of the cell as a whole.
  static double implicit_step(double step);
  /// Conductance that a circuit adds to a stage beside `SheetStage::circuit`'s start: 1/R and C
  /// over the step.
  double circuit_conductance(double step) const;

  /// The potential of the lead of the top electrode: given, or by the circuit.
  double lead_potential(const SheetStage& stage, double potential_bottom, double potential_top,
                        std::span<const double> top) const;
  /// Change of the lead's potential with one of the potentials of the top wall.
  double lead_change(const SheetStage& stage, std::span<const double> change) const;

  /// Subtracts from `charge` the charge that comes to every column of a wall within the step, by
  /// its potentials and that of its lead.
  void take_inflow(std::size_t wall, double step, std::span<const double> potential, double lead,
                   std::span<double> charge) const;

private:
  double contact_mean(std::span<const double> top, double origin) const;

  const ScaledGrid& grid_;
  std::array<double, 2> conductance_;
  Contact contact_;
  std::optional<ScaledAdmittance> admittance_;
  std::vector<std::size_t> touched_;
  std::vector<double> touched_share_; ///< conductance to a contact over that of a square of metal
  double total_share_ = 0;
};

/// Nothing where both electrodes are equipotentials: without sheet resistance, or touched
/// everywhere.
/// @param scaled the solved part of the grid
std::optional<SheetElectrodes> sheet_electrodes(const Case& input, const DerivedScales& scales,
                                                const MidWidthMirror& mirror,
                                                const ScaledGrid& scaled);

} // namespace ionskin::electrochemistry
