// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/electrochemistry/circuit/wall_electrodes.hpp"
#include "ionskin/electrochemistry/grid/derived_scales.hpp"
#include "ionskin/electrochemistry/grid/mid_width_mirror.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace ionskin::electrochemistry {

/// Electrodes of a case whose taxels have circuits of their own, cut into conductors.
/// `cut_electrode` makes them.
struct CutElectrode {
  /// Conductors on the solved part of the transport grid. For a crossbar they are its lines in the
  /// order of `Readout::lines`, on the whole grid.
  WallElectrodes conductors;
  /// Index of the conductor on the top face that contains each segment (see
  /// `make_electrode_segments`).
  std::vector<std::size_t> conductor_of_segment;
  /// Row of the scan in which each conductor is read; nothing for conductors that are connected all
  /// the time: the common electrode, the columns of a crossbar, and all of them without a scan.
  std::vector<std::optional<std::size_t>> row_of_conductor;
  /// Charge of each conductor on the whole skin over its charge on the solved part, 1 or 2.
  std::vector<double> copies;
  /// Index of the conductor on the bottom face below each segment; empty where the bottom face is
  /// not cut.
  std::vector<std::size_t> row_of_segment{};

  /// Circuits of the conductors while a scan reads a row, one entry for each; an empty entry is a
  /// conductor at the ground. Conductors of other rows are grounded or open, as `scan` says.
  std::vector<std::optional<ScaledAdmittance>> circuits(const Scan& scan, std::size_t row) const;
};

/// Computes the instants between `begin` and `end` [s] at which a scan goes to the next row; none
/// without a scan. Throws UserError when there are too many.
std::vector<double> scan_switches(const Readout& readout, double begin, double end);

/// True if the circuits of the taxels are symmetric about mid-width. A crossbar is so only if the
/// ground holds all its lines.
/// @param width of the skin [m]
bool taxels_are_mirrored(const Readout& readout, double width);

/// Cuts the electrodes of a case into conductors; nothing where each electrode is one conductor. A
/// taxel with a circuit of its own is a conductor. The other taxels and the area without taxels are
/// one conductor, the common electrode, with the circuit of the electrode. Where half of the skin
/// is solved, two taxels that mirror each other about mid-width are one conductor. Gaps between
/// taxels that are narrower than a hundredth of a column are no conductor: the taxels beside them
/// cover them. The conductors of a crossbar are its lines.
/// @param grid transport grid of the whole skin
/// @param mirror part of the grid that is solved
std::optional<CutElectrode> cut_electrode(const Case& input, const DerivedScales& scales,
                                          const TransportGrid& grid, const MidWidthMirror& mirror);

} // namespace ionskin::electrochemistry
