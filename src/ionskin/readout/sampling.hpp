// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/readout/charge_relaxation.hpp"
#include "ionskin/readout/signals.hpp"

#include <vector>

namespace ionskin::readout {

/// Currents that an integrating instrument reads, docs/model.md (30): the charge gained over each
/// readout interval divided by it. Between the rows half the difference of the charges relaxes by a
/// cubic and the rest is linear. Unlike the resolved peaks these converge with the time step. The
/// intervals start at the first row, whose impulse charge is not part of the first interval; a last
/// interval that the run does not complete is dropped.
/// @param signals with time, charge_top and charge_bottom
/// @param interval readout interval [s], positive
/// @param relaxation at the rows; without it every charge is linear between them
/// @return columns time (end of each interval), current_top, current_bottom, current_difference and
///         current_common; no cycle and phase, because an interval may span several
SignalTable sample_currents(const SignalTable& signals, double interval,
                            const ChargeRelaxation& relaxation = {});

/// A table over time as the same instrument sees it, with the same rows as `sample_currents`: of a
/// charge its value at the end of the interval, of a current the charge gained divided by the
/// interval, of a voltage its mean. Linear between the rows.
/// @param table with time; the charge of a column current* is the column charge* of the same ending
SignalTable sample_table(const SignalTable& table, double interval);

} // namespace ionskin::readout
