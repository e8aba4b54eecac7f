// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/electrochemistry/grid/charges.hpp"
#include "ionskin/electrochemistry/output/ion_solution.hpp"
#include "ionskin/history/core_history.hpp"

#include <span>
#include <vector>

namespace ionskin::electrochemistry {

/// True if a strain history is symmetric about mid-width at every sample, to rounding. The ions
/// then are symmetric, too, and half of the columns suffices.
bool is_mirrored(const history::CoreHistory& history);

/// Part of the transport grid that is solved, and the way back to the whole grid. Only the half at
/// lower y is solved where history and circuits are symmetric about mid-width and the number of
/// columns along y is even, else the whole grid.
class MidWidthMirror {
public:
  /// @param whole transport grid of the whole skin
  /// @param readout_is_mirrored false where the circuits of the electrodes are not symmetric about
  ///   mid-width
  MidWidthMirror(const TransportGrid& whole, const history::CoreHistory& history,
                 bool readout_is_mirrored = true);

  const TransportGrid& solved_grid() const { return solved_; }
  /// Number of solved parts that make the whole grid, 1 or 2.
  double copies() const { return halved_ ? 2.0 : 1.0; }
  /// Extends a field from the solved part to the whole grid, [z][y][x] or [y][x].
  std::vector<double> whole(std::span<const double> solved) const;
  /// Extends the charges of the columns, and their sums, from the solved part to the whole grid.
  void complete(WallCharges& charges) const;

private:
  TransportGrid solved_;
  bool halved_;
};

} // namespace ionskin::electrochemistry
