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

/// The electrodes of a case whose taxels have circuits of their own.
struct CutElectrode {
  /// Conductors on the solved part of the grid; the lines of a crossbar (Readout::lines), in their
  /// order and on the whole grid.
  WallElectrodes conductors;
  /// Conductor of the top face of which each segment is a part (see `make_electrode_segments`).
  std::vector<std::size_t> conductor_of_segment;
  /// Row with which each conductor is read; nothing for the electrode, and without a scan.
  std::vector<std::optional<std::size_t>> row_of_conductor;
  /// Number of copies of each conductor: the whole grid has so many times the charge of the solved
  /// part.
  std::vector<double> copies;
  /// Conductor of the bottom face below each segment; empty where that face is not cut.
  std::vector<std::size_t> row_of_segment{};

  /// The circuits of the conductors while a row is read.
  std::vector<std::optional<ScaledAdmittance>> circuits(const Scan& scan, std::size_t row) const;
};

/// Instants between two others [s] at which a scan goes to the next row; none without a scan.
/// Throws UserError where they are too many.
std::vector<double> scan_switches(const Readout& readout, double begin, double end);

/// True if the circuits of the taxels are their own mirror image about mid-width, as far as any of
/// them has a potential.
bool taxels_are_mirrored(const Readout& readout, double width);

/// Nothing where each electrode is one conductor. A taxel with a circuit of its own is a
/// conductor; the other taxels and what no taxel covers are the electrode, which has that of the
/// electrode. Taxels that mirror each other about mid-width, where half of the skin is solved, are
/// one conductor. Strips between taxels that are narrower than a hundredth of a column are none. A
/// crossbar has its lines as conductors.
/// @param grid the whole one
std::optional<CutElectrode> cut_electrode(const Case& input, const DerivedScales& scales,
                                          const TransportGrid& grid, const MidWidthMirror& mirror);

} // namespace ionskin::electrochemistry
