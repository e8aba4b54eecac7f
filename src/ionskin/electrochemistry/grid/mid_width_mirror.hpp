// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/electrochemistry/grid/charges.hpp"
#include "ionskin/electrochemistry/output/ion_solution.hpp"
#include "ionskin/history/core_history.hpp"

#include <span>
#include <vector>

namespace ionskin::electrochemistry {

/// True if the shear is, to rounding, its own mirror image about mid-width at every sample. Then
/// the ions are too, and half of the columns suffice.
bool is_mirrored(const history::CoreHistory& history);

/// The part of a transport grid that is solved, and the way back to the whole: the half of lower y
/// where the history is mirrored about mid-width and the columns come in pairs, else all of it.
class MidWidthMirror {
public:
  /// @param readout_is_mirrored false where the circuits of the top face are not mirror images
  MidWidthMirror(const TransportGrid& whole, const history::CoreHistory& history,
                 bool readout_is_mirrored = true);

  const TransportGrid& solved_grid() const { return solved_; }
  /// Number of times that the solved part is in the whole.
  double copies() const { return halved_ ? 2.0 : 1.0; }
  /// A field on the whole grid from its solved part, [z][y][x] or [y][x].
  std::vector<double> whole(std::span<const double> solved) const;
  /// Charges of all columns, and their sums.
  void complete(WallCharges& charges) const;

private:
  TransportGrid solved_;
  bool halved_;
};

} // namespace ionskin::electrochemistry
