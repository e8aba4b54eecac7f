// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/cell_circuit.hpp"

#include "ionskin/electrochemistry/equations/steric_excess.hpp"
#include "ionskin/electrochemistry/grid/derived_scales.hpp"

#include <cmath>
#include <numbers>

namespace ionskin::electrochemistry {

CellCircuit cell_circuit(const Case& input) {
  const double thickness = input.skin.core_thickness(), area = input.skin.length * input.skin.width,
               permittivity = input.electrochemistry.permittivity;
  const DerivedScales scales = derive_scales(input.electrochemistry, thickness);
  const auto excess = steric_excess(input.electrochemistry);
  // Double layers of ions of finite size are thicker.
  const double screened = scales.debye_length * (excess ? std::sqrt(1 / excess->room(1.0)) : 1.0);
  const double interface = scales.area_ratio * permittivity / screened;
  CellCircuit circuit;
  circuit.layers = area * interface / 2;
  circuit.geometric = area * permittivity / thickness;
  circuit.core = thickness / (scales.conductivity * area);
  circuit.screening = circuit.core * circuit.geometric;
  circuit.charging = circuit.core * circuit.layers;
  const auto resistances = input.skin.sheet_resistances();
  circuit.metal_squares = input.has_sheet_resistance() ? resistances[0] + resistances[1] : 0.0;
  const double reach =
      (input.readout.contact == ElectrodeContact::both_ends ? 0.5 : 1.0) * input.skin.length;
  circuit.metal_time_per_ohm =
      4 / (std::numbers::pi * std::numbers::pi) * circuit.layers / area * reach * reach;
  return circuit;
}

} // namespace ionskin::electrochemistry
