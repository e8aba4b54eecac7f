// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/readout/signals.hpp"
#include "ionskin/study/metrics/read_out.hpp"

#include <map>
#include <string>

namespace ionskin::study {

/// Difference of the signals of two runs.
struct TableDifference {
  readout::SignalTable table; ///< second minus first, at the instants of the reference
  /// Root mean square over time of the difference over that of the first, by column [1]; 0 where
  /// the first vanishes.
  std::map<std::string, double> relative_norm;
};

/// Difference of tables of quantities that are linear between their rows, at the instants of a
/// reference with the same columns.
TableDifference table_difference(const readout::SignalTable& reference,
                                 const readout::SignalTable& first,
                                 const readout::SignalTable& second);

/// Difference of `signals.csv`: currents and rates are means over the steps of the reference,
/// whatever the steps of the two.
TableDifference resolved_difference(const readout::SignalTable& reference, const Signals& first,
                                    const Signals& second);

} // namespace ionskin::study
