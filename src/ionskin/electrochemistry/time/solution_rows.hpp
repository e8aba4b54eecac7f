// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/electrochemistry/circuit/cut_electrode.hpp"
#include "ionskin/electrochemistry/circuit/electrode_segments.hpp"
#include "ionskin/electrochemistry/equations/space_charge.hpp"
#include "ionskin/electrochemistry/grid/charges.hpp"
#include "ionskin/electrochemistry/grid/derived_scales.hpp"
#include "ionskin/electrochemistry/grid/mid_width_mirror.hpp"
#include "ionskin/electrochemistry/grid/scaled_grid.hpp"
#include "ionskin/electrochemistry/output/ion_solution.hpp"
#include "ionskin/electrochemistry/output/ion_state.hpp"
#include "ionskin/electrochemistry/time/time_integrator.hpp"

#include <string>
#include <vector>

namespace ionskin::electrochemistry {

/// Adds the charges of the parts of the top electrode as they stand.
/// @param unit of the charges [C]
void append_segments(const ElectrodeSegments& segments, const WallCharges& charges, double unit,
                     IonSolution& solution);

/// Adds where the water stands at the last accepted instant.
/// @param area of the skin [m2]
void append_water(const poroelasticity::StreamingDrive& water, double area, WaterRows& rows);

/// Turns scaled states into rows and snapshots of an IonSolution in SI units. The fixed charge must
/// stand at the instant of the state.
class SolutionRows {
public:
  /// @param grid the whole one
  /// @param mirror says which part of it `scaled` is
  /// @param landings instants on which steps end [s]
  /// @param snapshot_times wanted instants [s]; each is kept at the nearest of them
  /// @param cut the conductors of cut faces; must outlive this, nullptr for one on each face
  SolutionRows(const Case& input, const DerivedScales& scales, const TransportGrid& grid,
               const MidWidthMirror& mirror, const ScaledGrid& scaled,
               const FixedCharge& fixed_charge, const std::vector<double>& landings,
               const std::vector<double>& snapshot_times, const CutElectrode* cut = nullptr);

  /// Appends the row of an instant to the solution, and a snapshot where one is wanted.
  /// @param electrodes the conductors of cut faces
  /// @param row that a scan has read until this instant; nothing without one
  /// @param lead_voltage of metal with sheet resistances; nothing without
  void append(double time, const IonState& state, const Relaxation& relaxation,
              const std::vector<ElectrodeRow>& electrodes, std::optional<std::size_t> row,
              std::optional<double> lead_voltage, IonSolution& solution);
  /// Adds the fields that are kept for the last row only.
  void finish(const IonState& state, IonSolution& solution);

private:
  void append_conductors(const std::vector<ElectrodeRow>& electrodes,
                         std::optional<std::size_t> read, IonSolution& solution) const;
  /// Appends the rows of conductors that the ground holds, which the solver takes for one.
  void append_held(std::optional<std::size_t> read, IonSolution& solution) const;
  /// Gives to what has no circuit of its own what is left of the charge of the top electrode: the
  /// circuits know theirs to rounding, the walls theirs as Newton left them.
  void give_rest(IonSolution& solution) const;
  /// Appends the rows of the lines of a crossbar and of their crossings.
  void append_lines(const std::vector<ElectrodeRow>& lines, std::optional<std::size_t> read,
                    IonSolution& solution) const;
  /// Half of the net charge below every column of the whole grid, which returns through the ground.
  std::vector<double> net_of_columns() const;
  /// The lines of a crossbar that the ground holds.
  std::vector<ElectrodeRow> held_lines() const;
  IonSnapshot snapshot(double time, const IonState& state) const;

  const MidWidthMirror& mirror_;
  const ScaledGrid& scaled_;
  const FixedCharge& fixed_charge_;
  double charge_unit_;        ///< F c0 lambda times the area of a column [C]
  double mean_unit_;          ///< the same times the number of columns [C]
  double area_;               ///< of the skin [m2]
  double time_unit_;          ///< relaxation time [s]
  double volume_unit_;        ///< lambda times the area of a column [m3]
  double concentration_unit_; ///< c0 / v [mol/m3]
  double potential_unit_;     ///< R T / (v F) [V]
  std::vector<double> snapshot_times_;
  WallCharges charges_;
  ElectrodeSegments segments_;
  const CutElectrode* cut_;
  std::vector<bool> is_own_; ///< true where a segment is a taxel with a circuit of its own
  std::vector<std::size_t> row_of_taxel_; ///< of a scan
  std::vector<double> segment_area_;      ///< in columns
  std::vector<std::string> line_names_;   ///< of a crossbar
};

} // namespace ionskin::electrochemistry
