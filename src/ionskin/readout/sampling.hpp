// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/readout/charge_relaxation.hpp"
#include "ionskin/readout/signals.hpp"

#include <vector>

namespace ionskin::readout {

/// Start of a run, then the end of every readout interval that the run completes [s].
/// @param time of the rows [s], ascending
/// @param interval readout interval [s], positive
std::vector<double> interval_ends(const std::vector<double>& time, double interval);

/// Currents that an integrating instrument reads, docs/model.md (30): charge gained over each
/// readout interval, divided by the interval. Unlike the resolved peaks, these converge as the time
/// step is refined. Between the rows, half the difference of the charges follows `relaxation`, and
/// the rest is linear. The intervals start at the first row, so that the first one does not contain
/// its impulse charge; a last interval that the run does not complete is dropped.
/// @param signals with the columns time, charge_top and charge_bottom
/// @param interval readout interval [s], positive
/// @param relaxation at the rows; if empty, charges are linear between the rows
/// @returns columns time (end of each interval), current_top, current_bottom, current_difference
/// and current_common; `cycle` and `phase` are empty, because an interval may span several
SignalTable sample_currents(const SignalTable& signals, double interval,
                            const ChargeRelaxation& relaxation = {});

/// Samples a table over time as an integrating instrument would, on the intervals of
/// `sample_currents`. Takes charges at the end of an interval, currents as the charge gained
/// divided by the interval, and all other quantities as their mean over the interval. Columns are
/// linear between the rows.
/// @param table with a column time, and for each column current* a column charge* with the same
/// ending
/// @param interval readout interval [s], positive
SignalTable sample_table(const SignalTable& table, double interval);

} // namespace ionskin::readout
