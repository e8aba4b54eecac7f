// SPDX-License-Identifier: Apache-2.0
#include "ionskin/readout/signals.hpp"

#include "ionskin/base/error.hpp"

#include <algorithm>

namespace ionskin::readout {

const Signal& SignalTable::column(const std::string& name) const {
  const auto found = std::find_if(columns.begin(), columns.end(),
                                  [&](const Signal& signal) { return signal.name == name; });
  if (found == columns.end()) {
    throw InternalError("the signal table has no column '" + name + "'");
  }
  return *found;
}

} // namespace ionskin::readout
