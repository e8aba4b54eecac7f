// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/circuit/external_circuit.hpp"

#include "ionskin/circuits/circuit.hpp"

namespace ionskin::electrochemistry {

std::optional<ScaledAdmittance> scaled_admittance(const Readout& readout,
                                                  const DerivedScales& scales, double area) {
  const auto admittance = circuits::circuit(readout.circuit, readout.parameters).admittance;
  if (!admittance) {
    return std::nullopt;
  }
  return ScaledAdmittance{scales.potential_scale * scales.relaxation_time /
                              (admittance->resistance * scales.charge_density * area),
                          admittance->capacitance * scales.potential_scale /
                              (scales.charge_density * area)};
}

} // namespace ionskin::electrochemistry
