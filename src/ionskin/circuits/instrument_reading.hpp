// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace ionskin::circuits {

/// Named number that an instrument adds to the metrics of a run, such as its largest current.
struct InstrumentFigure {
  std::string name;
  double value = 0;
  std::string unit;
};

/// Reading of a circuit's own instrument. `current` and `charge` have one entry per row of the run.
struct InstrumentReading {
  std::vector<double> current; ///< shown at the rows [A]
  std::vector<double> charge;  ///< integral of the shown current since the start [C]
  std::vector<InstrumentFigure> figures;
  std::vector<std::string> warnings; ///< sentences for the user, such as that the instrument clips
};

} // namespace ionskin::circuits
