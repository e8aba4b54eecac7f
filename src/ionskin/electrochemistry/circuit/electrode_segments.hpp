// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/electrochemistry/output/ion_solution.hpp"

#include <span>
#include <string>
#include <vector>

namespace ionskin::electrochemistry {

/// Parts of the top electrode, each at the electrode's potential: the case's taxels, then "rest"
/// for what they leave over. The charge of a column is uniform over its area, so that a part takes
/// of it the exact share of the area that it covers.
struct ElectrodeSegments {
  std::vector<std::string> names;
  std::vector<std::vector<double>> share; ///< of each column's charge [segment][y][x], 0 to 1

  /// Charge of each segment, in the unit of `column_charge` [y][x].
  std::vector<double> charges(std::span<const double> column_charge) const;
};

/// No segments without taxels; no "rest" where the taxels cover the whole face.
ElectrodeSegments make_electrode_segments(const std::vector<Taxel>& taxels,
                                          const TransportGrid& grid);

} // namespace ionskin::electrochemistry
