// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/checks/check_crossbar.hpp"

#include "ionskin/circuits/circuit.hpp"

#include <fmt/format.h>

namespace ionskin {

void check_crossbar(const CaseDocument& document, Problems& problems) {
  const Readout& readout = document.input.readout;
  const std::vector<Pointer> of_rows = document.point_at("readout.row_circuit");
  if (!readout.is_crossbar() && !of_rows.empty())
    problems.add("readout.row_circuit is given, but no rows are conductors of their own", of_rows,
                 "add wiring = \"crossbar\" to a grid of readout.taxels, or remove the key");
  if (!readout.is_crossbar() || readout.taxels.empty())
    return;
  if (readout.taxel_grid.gap > 0)
    problems.add("the lines of a crossbar touch, and readout.taxels.gap is given: strips without "
                 "metal are not modelled",
                 document.point_at("readout.taxels.gap"), "remove readout.taxels.gap");
  if (readout.taxel_circuit == shared_circuit &&
      !document.point_at("readout.taxel_circuit").empty())
    problems.add("readout.taxel_circuit = \"shared\" makes one conductor of the taxels, and "
                 "readout.taxels.wiring = \"crossbar\" cuts both electrodes into lines",
                 document.point_at("readout.taxel_circuit"),
                 "set readout.taxel_circuit = \"short\" or another circuit of the columns, or "
                 "readout.taxels.wiring = \"single\"");
  const auto holds = [](const std::string& circuit) {
    return circuits::circuit_row(circuit).holds_potential;
  };
  // With a single row the scan never leaves it, so that no other rows are grounded.
  const bool others_are_held =
      readout.scan.dwell > 0 && readout.scan.grounds_others && readout.taxel_grid.rows > 1;
  if (!holds(readout.circuit_of(0)) && !holds(readout.row_circuit) && !others_are_held)
    problems.add(fmt::format("no line of the crossbar is at the ground: the columns have the "
                             "circuit \"{}\", the rows \"{}\"",
                             readout.circuit_of(0), readout.row_circuit),
                 document.point_at("readout.row_circuit"),
                 "set readout.row_circuit = \"short\", so that the row that is read is the ground "
                 "of its crossings");
}

std::vector<std::string> notes_on_crossbar(const CaseDocument& document) {
  const Readout& readout = document.input.readout;
  if (!readout.is_crossbar() || readout.scan.dwell == 0 || readout.taxel_grid.rows == 1 ||
      !readout.lines_are_held())
    return {};
  return {"The ground holds every line of the crossbar, read or not: a column passes the charge of "
          "all its crossings at any time, and its current does not tell them apart. Set "
          "readout.scan.others = \"open\", or compare the currents of the columns with those of "
          "the rows."};
}

} // namespace ionskin
