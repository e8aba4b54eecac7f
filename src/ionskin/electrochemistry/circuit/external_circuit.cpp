// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/circuit/external_circuit.hpp"

namespace ionskin::electrochemistry {

std::optional<double> circuit_conductance(const Readout& readout, const DerivedScales& scales,
                                          double area) {
  switch (readout.circuit) {
  case ReadoutCircuit::open:
    return 0.0;
  case ReadoutCircuit::load:
    return scales.potential_scale * scales.relaxation_time /
           (readout.load_resistance * scales.charge_density * area);
  case ReadoutCircuit::short_circuit:
  case ReadoutCircuit::amplifier:
    return std::nullopt;
  }
  return std::nullopt;
}

} // namespace ionskin::electrochemistry
