// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/case.hpp"

#include <cmath>
#include <cstddef>

namespace ionskin {

bool Readout::has_own_circuit(std::size_t taxel) const {
  return !taxels[taxel].circuit.empty() ? taxels[taxel].circuit != shared_circuit
                                        : taxel_circuit != shared_circuit;
}

bool Readout::is_cut() const {
  for (std::size_t i = 0; i < taxels.size(); ++i) {
    if (has_own_circuit(i)) {
      return true;
    }
  }
  return false;
}

const std::string& Readout::circuit_of(std::size_t taxel) const {
  if (!has_own_circuit(taxel)) {
    return circuit;
  }
  return taxels[taxel].circuit.empty() ? taxel_circuit : taxels[taxel].circuit;
}

laws::LawValues Readout::parameters_of(std::size_t taxel) const {
  laws::LawValues values = parameters;
  for (const auto& [name, value] : taxels[taxel].parameters) {
    values.insert_or_assign(name, value);
  }
  return values;
}

std::size_t Readout::scan_row(std::size_t taxel) const {
  return taxel_grid.rows > 0 ? taxel / static_cast<std::size_t>(taxel_grid.columns) : taxel;
}

std::size_t Readout::row_read_at(double time) const {
  constexpr double rounding = 1e-6; // of a dwell: an instant next to a switch is the switch
  const std::size_t rows = scan_row(taxels.size() - 1) + 1;
  return static_cast<std::size_t>(std::floor(time / scan.dwell + rounding)) % rows;
}

} // namespace ionskin
