// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/readout/signals.hpp"
#include "ionskin/study/metrics/read_out.hpp"

#include <map>
#include <string>

namespace ionskin::study {

/// Difference of the signals of two solutions.
struct TableDifference {
  readout::SignalTable table; ///< second minus first solution, at the instants of the reference
  /// For each column, root mean square over time of the difference, divided by that of the first
  /// solution [1]; 0 where the first vanishes.
  std::map<std::string, double> relative_norm;
};

/// Subtracts two tables of quantities that are linear between their rows, at the instants of a
/// reference table.
/// @param reference table whose rows and columns the result has
TableDifference table_difference(const readout::SignalTable& reference,
                                 const readout::SignalTable& first,
                                 const readout::SignalTable& second);

/// Subtracts two resolved tables (signals.csv) at the instants of a reference. Currents and rates
/// are means over the time steps of the reference, whatever time steps the two solutions have.
/// @param reference resolved table of the run
TableDifference resolved_difference(const readout::SignalTable& reference, const Signals& first,
                                    const Signals& second);

} // namespace ionskin::study
