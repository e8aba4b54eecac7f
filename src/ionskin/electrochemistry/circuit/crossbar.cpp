// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/circuit/crossbar.hpp"

#include "ionskin/circuits/circuit.hpp"
#include "ionskin/electrochemistry/circuit/electrode_segments.hpp"

#include <utility>

namespace ionskin::electrochemistry {

CutElectrode crossbar(const Case& input, const DerivedScales& scales, const TransportGrid& grid) {
  const Readout& readout = input.readout;
  const std::vector<Taxel> lines = readout.lines();
  const auto columns = static_cast<std::size_t>(readout.taxel_grid.columns);
  const double column_area =
      input.skin.length * input.skin.width /
      static_cast<double>((grid.x_edges.size() - 1) * (grid.y_edges.size() - 1));
  std::vector<WallConductor> conductors;
  std::vector<std::optional<std::size_t>> rows;
  for (std::size_t e = 0; e < lines.size(); ++e) {
    WallConductor conductor{std::move(make_electrode_segments({lines[e]}, grid).share.front()),
                            std::nullopt, e < columns ? top_wall : bottom_wall};
    const circuits::Circuit circuit = circuits::circuit(lines[e].circuit, readout.parameters);
    if (circuit.admittance) {
      conductor.admittance = scaled_admittance(*circuit.admittance, scales, column_area);
    }
    rows.push_back(e >= columns && readout.scan.dwell > 0 ? std::optional(e - columns)
                                                          : std::nullopt);
    conductors.push_back(std::move(conductor));
  }
  std::vector<std::size_t> above, below;
  for (std::size_t i = 0; i < readout.taxels.size(); ++i) {
    above.push_back(i % columns);
    below.push_back(columns + i / columns);
  }
  std::vector<double> copies(conductors.size(), 1.0);
  return {WallElectrodes(std::move(conductors)), std::move(above), std::move(rows),
          std::move(copies), std::move(below)};
}

} // namespace ionskin::electrochemistry
