// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/circuit/external_circuit.hpp"

namespace ionskin::electrochemistry {

ScaledAdmittance scaled_admittance(const circuits::Admittance& admittance,
                                   const DerivedScales& scales, double area) {
  return {scales.potential_scale * scales.relaxation_time /
              (admittance.resistance * scales.charge_density * area),
          admittance.capacitance * scales.potential_scale / (scales.charge_density * area)};
}

std::optional<ScaledAdmittance> scaled_admittance(const Readout& readout,
                                                  const DerivedScales& scales, double area) {
  const auto admittance = circuits::circuit(readout.circuit, readout.parameters).admittance;
  if (!admittance) {
    return std::nullopt;
  }
  return scaled_admittance(*admittance, scales, area);
}

} // namespace ionskin::electrochemistry
