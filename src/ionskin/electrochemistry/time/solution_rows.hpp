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
#include "ionskin/electrochemistry/time/electrode_charges.hpp"

#include <string>
#include <vector>

namespace ionskin::electrochemistry {

/// Appends a row with the charges of the segments of the top electrode to a solution.
/// @param charges of both walls, on the columns of the whole grid
/// @param unit of `charges` [C]
void append_segments(const ElectrodeSegments& segments, const WallCharges& charges, double unit,
                     IonSolution& solution);

/// Appends a row with the state of the water at the last accepted instant.
/// @param area of the skin [m2]
void append_water(const poroelasticity::StreamingDrive& water, double area, WaterRows& rows);

/// Writer of an IonSolution: converts scaled states of the solver to rows and snapshots in SI
/// units. `fixed_charge` must be evaluated at the instant of each state.
class SolutionRows {
public:
  /// @param grid transport grid of the whole skin
  /// @param mirror part of that grid which `scaled` is
  /// @param fixed_charge must outlive this, as must `mirror` and `scaled`
  /// @param landings instants on which time steps end [s]
  /// @param snapshot_times instants of the snapshots wanted [s]; each is taken at the nearest
  ///   landing
  /// @param cut conductors of cut faces; must outlive this; nullptr where each face has one
  ///   conductor
  SolutionRows(const Case& input, const DerivedScales& scales, const TransportGrid& grid,
               const MidWidthMirror& mirror, const ScaledGrid& scaled,
               const FixedCharge& fixed_charge, const std::vector<double>& landings,
               const std::vector<double>& snapshot_times, const CutElectrode* cut = nullptr);

  /// Appends the row of an instant to the solution, and a snapshot where one is wanted.
  /// @param time [s]
  /// @param electrodes state of the electrodes at this instant
  /// @param row row that a scan has read until this instant; nothing without a scan
  void append(double time, const IonState& state, const ElectrodeReading& electrodes,
              std::optional<std::size_t> row, IonSolution& solution);
  /// Adds to a solution the fields that only the last row has.
  void finish(const IonState& state, IonSolution& solution);

private:
  void append_conductors(const std::vector<ElectrodeRow>& electrodes,
                         std::optional<std::size_t> read, IonSolution& solution) const;
  /// Appends the rows of conductors that are all held by the ground, which the solver treats as
  /// one.
  void append_held(std::optional<std::size_t> read, IonSolution& solution) const;
  /// Gives the segments without circuits of their own the rest of the top electrode's charge:
  /// circuits know their charge to rounding, the charges on the walls are as accurate as Newton's
  /// method left them.
  void give_rest(IonSolution& solution) const;
  /// Appends the rows of the lines of a crossbar and of their crossings.
  void append_lines(const std::vector<ElectrodeRow>& lines, std::optional<std::size_t> read,
                    IonSolution& solution) const;
  /// Rows of the lines of a crossbar whose lines are all held by the ground.
  std::vector<ElectrodeRow> held_lines() const;
  IonSnapshot snapshot(double time, const IonState& state) const;

  const MidWidthMirror& mirror_;
  const ScaledGrid& scaled_;
  const FixedCharge& fixed_charge_;
  double charge_unit_;        ///< F c0 lambda times the area of a column [C]
  double mean_unit_;          ///< `charge_unit_` times the number of columns of the whole grid [C]
  double area_;               ///< of the skin [m2]
  double time_unit_;          ///< relaxation time lambda^2/D [s]
  double volume_unit_;        ///< lambda times the area of a column [m3]
  double concentration_unit_; ///< c0 / v [mol/m3]
  double potential_unit_;     ///< R T / (v F) [V]
  std::vector<double> snapshot_times_;
  WallCharges charges_;
  ElectrodeSegments segments_;
  const CutElectrode* cut_;
  std::vector<bool> is_own_; ///< true where a segment is a taxel with a circuit of its own
  std::vector<std::size_t> row_of_taxel_; ///< row of the scan that each taxel is read in
  std::vector<double> segment_area_;      ///< area of each segment, in columns
  std::vector<std::string> line_names_;   ///< names of the lines of a crossbar
};

} // namespace ionskin::electrochemistry
