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

/// Equations that electrodes with a sheet resistance add to one implicit stage, scaled. The charge
/// per area of every column is its `start` plus `step` times the current that comes along the metal
/// and from the lead.
struct SheetStage {
  std::array<std::vector<double>, 2> start; ///< [bottom, top][y][x]
  /// Mean of `start` over the top wall, without the net charge that returns through the ground.
  double passed = 0;
  double step = 0; ///< implicit part of the time step [relaxation times]
  /// Circuit between the leads; nothing where the potentials of both leads are given.
  std::optional<CircuitStage> circuit;
};

/// Electrodes as two sheets of metal with leads at their ends. Charge moves along the metal by its
/// sheet resistance, docs/model.md (67). A lead is joined to each column that it touches by half a
/// column's length of metal.
class SheetElectrodes {
public:
  /// Columns whose outer side a lead touches: all columns with an x index in `columns_x` and a y
  /// index in `columns_y`. `share_y` is the touched share of the width of each of `columns_y`, 0 to
  /// 1.
  struct Contact {
    std::vector<std::size_t> columns_x, columns_y;
    std::vector<double> share_y;
  };

  /// @param grid solved part of the grid; must outlive this
  /// @param conductance of a square of the bottom and of the top metal [F c0 lambda^3 v F / (tau R
  ///   T)]
  /// @param admittance between the leads; nothing where their potentials are given
  SheetElectrodes(const ScaledGrid& grid, std::array<double, 2> conductance, Contact contact,
                  std::optional<ScaledAdmittance> admittance);

  double conductance(std::size_t wall) const { return conductance_[wall]; }
  const Contact& contact() const { return contact_; }
  const std::optional<ScaledAdmittance>& admittance() const { return admittance_; }
  /// Indices of the columns that the leads touch, row by row of `contact`.
  const std::vector<std::size_t>& touched() const { return touched_; }
  /// Conductance between the lead of a wall and each touched column, per area of a column, in the
  /// order of `touched`.
  std::vector<double> contact_conductance(std::size_t wall) const;
  /// Sum of `contact_conductance` over the touched columns.
  double total_contact(std::size_t wall) const;

  /// Limits the implicit part of a time step [relaxation times] for the metal from below. Where
  /// only Poisson's equation is solved, `step` is 0; a time in which next to no charge moves then
  /// fixes the potential of the cell as a whole.
  static double implicit_step(double step);
  /// Conductance of the circuit between the leads in a stage, step/R + C; 0 without a circuit.
  double circuit_conductance(double step) const;

  /// Potential of the lead of the top electrode [R T/(v F)]: as given, or as the circuit determines
  /// it.
  /// @param potential_bottom potential of the lead of the bottom electrode
  /// @param potential_top given potential, used without a circuit
  /// @param top potentials of the columns of the top wall [y][x]
  double lead_potential(const SheetStage& stage, double potential_bottom, double potential_top,
                        std::span<const double> top) const;
  /// Computes the change of the top lead's potential with a change of the potentials of the top
  /// wall [y][x]; 0 without a circuit.
  double lead_change(const SheetStage& stage, std::span<const double> change) const;

  /// Subtracts from `charge` the charge per area that reaches every column of a wall within `step`,
  /// along the metal and from the lead.
  /// @param step implicit part of the time step [relaxation times]
  /// @param potential of the columns of the wall [y][x]
  /// @param lead potential of the wall's lead
  /// @param charge per area of the columns [y][x]
  void take_inflow(std::size_t wall, double step, std::span<const double> potential, double lead,
                   std::span<double> charge) const;

private:
  double contact_mean(std::span<const double> top, double origin) const;

  const ScaledGrid& grid_;
  std::array<double, 2> conductance_;
  Contact contact_;
  std::optional<ScaledAdmittance> admittance_;
  std::vector<std::size_t> touched_;
  std::vector<double> touched_share_; ///< conductance to the lead over that of a square of metal
  double total_share_ = 0;
};

/// Makes the electrodes of a case with sheet resistances; nothing where both electrodes are
/// equipotential, without sheet resistance or touched everywhere by the leads.
/// @param scaled solved part of the grid
std::optional<SheetElectrodes> sheet_electrodes(const Case& input, const DerivedScales& scales,
                                                const MidWidthMirror& mirror,
                                                const ScaledGrid& scaled);

} // namespace ionskin::electrochemistry
