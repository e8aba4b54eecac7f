// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/case.hpp"

#include "ionskin/circuits/circuit.hpp"

#include <cmath>
#include <cstddef>
#include <string>

namespace ionskin {

std::vector<Taxel> Readout::lines() const {
  std::vector<Taxel> lines;
  if (!is_crossbar() || taxels.empty()) {
    return lines;
  }
  const auto columns = static_cast<std::size_t>(taxel_grid.columns);
  const std::array<double, 2> far = taxels.back().upper;
  for (std::size_t j = 0; j < columns; ++j) {
    lines.push_back({"c" + std::to_string(j + 1),
                     taxels[j].lower,
                     {taxels[j].upper[0], far[1]},
                     circuit_of(j),
                     {}});
  }
  for (std::size_t i = 0; i < taxels.size(); i += columns) {
    lines.push_back({"r" + std::to_string(i / columns + 1),
                     taxels[i].lower,
                     {far[0], taxels[i].upper[1]},
                     row_circuit,
                     {}});
  }
  return lines;
}

bool Readout::lines_are_held() const {
  return circuits::circuit_row(circuit_of(0)).holds_potential &&
         circuits::circuit_row(row_circuit).holds_potential &&
         (scan.dwell == 0 || scan.grounds_others);
}

bool Readout::has_own_circuit(std::size_t taxel) const {
  if (is_crossbar()) {
    return true;
  }
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
  if (!taxels[taxel].circuit.empty()) {
    return taxels[taxel].circuit;
  }
  // The columns of a crossbar are separate conductors, so that "shared" means "short" for them.
  static const std::string grounded = "short";
  return taxel_circuit == shared_circuit ? grounded : taxel_circuit;
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
  constexpr double rounding =
      1e-6; // over the dwell: an instant this close to a switch counts as the switch
  const std::size_t rows = scan_row(taxels.size() - 1) + 1;
  return static_cast<std::size_t>(std::floor(time / scan.dwell + rounding)) % rows;
}

} // namespace ionskin
