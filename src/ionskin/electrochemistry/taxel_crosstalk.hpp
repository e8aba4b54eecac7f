// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/electrochemistry/circuit/cut_electrode.hpp"
#include "ionskin/electrochemistry/grid/transport_grid.hpp"
#include "ionskin/history/core_history.hpp"

#include <optional>

namespace ionskin::electrochemistry {

/// Crosstalk: how much of a signal of one taxel another one shows, in the cell at rest within one
/// readout interval (one implicit Euler step of it, docs/model.md (65)): the largest
///   |u_j / u_i| where charge is put on taxel i alone, if both have a voltage, or
///   |Q_j / Q_i| where taxel i alone leaves the ground, if j or both are held at it.
/// Nothing where fewer than two taxels have circuits of their own. Of a crossbar a unit charge that
/// a crossing drives from its row to its column is the signal: the largest ratio of what another
/// crossing shows of it, in the turn of its row by its column, over what the crossing itself shows;
/// without a scan the above of lines on the same face.
std::optional<double> taxel_crosstalk(const Case& input, const history::CoreHistory& history);

} // namespace ionskin::electrochemistry
