// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/electrochemistry/output/ion_solution.hpp"

#include <span>
#include <string>
#include <vector>

namespace ionskin::electrochemistry {

/// Parts (segments) of the top electrode whose charges are reported: the taxels of the case, then
/// "rest" for the area without taxels. The charge of a lateral column counts as uniform over its
/// area, so that a segment receives the exact share of the area that it covers.
struct ElectrodeSegments {
  std::vector<std::string> names;
  /// Share of each column that a segment covers [segment][y][x], 0 to 1.
  std::vector<std::vector<double>> share;

  /// Computes the charge of each segment from the charges of the columns [y][x], in the same unit.
  std::vector<double> charges(std::span<const double> column_charge) const;
};

/// Makes the segments from the taxels of a case: none without taxels, no "rest" where the taxels
/// cover the whole face.
ElectrodeSegments make_electrode_segments(const std::vector<Taxel>& taxels,
                                          const TransportGrid& grid);

} // namespace ionskin::electrochemistry
