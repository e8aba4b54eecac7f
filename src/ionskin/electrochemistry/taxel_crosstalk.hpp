// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/electrochemistry/circuit/cut_electrode.hpp"
#include "ionskin/electrochemistry/grid/transport_grid.hpp"
#include "ionskin/history/core_history.hpp"

#include <optional>

namespace ionskin::electrochemistry {

/// Computes the crosstalk between taxels [1]: the largest share of a signal of one taxel that
/// another taxel shows, in the cell at rest after one implicit Euler step of a readout interval,
/// docs/model.md (65). Nothing where fewer than two taxels have circuits of their own.
///
/// The signal is charge put on taxel i only, and the share |u_j / u_i|, if the potentials of both
/// are free; else taxel i leaves the ground, and the share is |Q_j / Q_i|. In a crossbar with a
/// scan the signal is a unit charge that a crossing drives from its row to its column, and the
/// share is the reading of another crossing (by its column, in the turn of its row) over the
/// crossing's own reading. In a crossbar without a scan the first two shares are taken between
/// lines of the same face.
/// @param history strain history, from which the transport grid follows
std::optional<double> taxel_crosstalk(const Case& input, const history::CoreHistory& history);

} // namespace ionskin::electrochemistry
