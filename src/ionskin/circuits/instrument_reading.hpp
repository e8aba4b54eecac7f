// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace ionskin::circuits {

/// A figure that an instrument adds to those of the run.
struct InstrumentFigure {
  std::string name;
  double value = 0;
  std::string unit;
};

/// Reading of an instrument, with one entry per row of the run.
struct InstrumentReading {
  std::vector<double> current; ///< at the rows [A]
  std::vector<double> charge;  ///< integral of the current since the start [C]
  std::vector<InstrumentFigure> figures;
  std::vector<std::string> warnings; ///< sentences that a reader must know
};

} // namespace ionskin::circuits
