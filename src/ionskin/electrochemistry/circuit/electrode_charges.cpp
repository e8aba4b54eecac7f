// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/circuit/electrode_charges.hpp"

#include <limits>
#include <utility>

namespace ionskin::electrochemistry {

ElectrodeCharges::ElectrodeCharges(const WallElectrodes& electrodes) : electrodes_(electrodes) {
  for (const WallConductor& conductor : electrodes.conductors()) {
    circuits_.push_back(conductor.admittance);
  }
}

void ElectrodeCharges::connect(std::vector<std::optional<ScaledAdmittance>> circuits) {
  circuits_ = std::move(circuits);
}

std::vector<double> ElectrodeCharges::rates(std::span<const double> potentials) const {
  std::vector<double> result(circuits_.size(), 0.0);
  for (std::size_t e = 0; e < result.size(); ++e) {
    if (circuits_[e]) {
      result[e] = -circuits_[e]->conductance * potentials[e];
    }
  }
  return result;
}

ElectrodeStage ElectrodeCharges::stage(std::span<const double> start, double implicit,
                                       std::span<const double> net) const {
  ElectrodeStage stage;
  for (std::size_t e = 0; e < circuits_.size(); ++e) {
    stage.start.push_back(start[e] + net[e]);
    stage.conductance.push_back(circuits_[e] ? implicit * circuits_[e]->conductance +
                                                   circuits_[e]->capacitance
                                             : std::numeric_limits<double>::infinity());
  }
  return stage;
}

} // namespace ionskin::electrochemistry
