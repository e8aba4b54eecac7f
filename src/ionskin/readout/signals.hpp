// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace ionskin::readout {

/// Named time series; `unit` is "1" for dimensionless quantities. NaN marks an empty entry.
struct Signal {
  std::string name;
  std::string unit;
  std::vector<double> values;
};

/// Table over time, as signals.csv has it: the numeric columns, of which `time` is the first.
/// `cycle` and `phase` are separate members because they are not physical quantities.
struct SignalTable {
  std::vector<int> cycle; ///< number of the motion's cycle at each row, from 1
  /// Phase of the motion at each row: touchdown, slide, lift, return; empty texts in runs from a
  /// strain file.
  std::vector<std::string> phase;
  std::vector<Signal> columns; ///< all of the same length

  /// Column of a name. Throws InternalError when there is none.
  const Signal& column(const std::string& name) const;
};

} // namespace ionskin::readout
