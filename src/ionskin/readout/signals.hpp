// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace ionskin::readout {

/// One named time series; `unit` is "1" for pure numbers. NaN marks an empty entry.
struct Signal {
  std::string name;
  std::string unit;
  std::vector<double> values;
};

/// Rows over time: `time` first, then the numeric columns in the order of signals.csv. `cycle` and
/// `phase` stand beside them because they are not quantities.
struct SignalTable {
  std::vector<int> cycle; ///< from 1
  std::vector<std::string>
      phase;                   ///< touchdown, slide, lift, return; empty in runs from a strain file
  std::vector<Signal> columns; ///< all of the same length

  const Signal& column(const std::string& name) const;
};

} // namespace ionskin::readout
