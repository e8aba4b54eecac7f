// SPDX-License-Identifier: Apache-2.0
#include "ionskin/poroelasticity/water_properties.hpp"

#include "ionskin/base/constants.hpp"
#include "ionskin/case/elastic_constants.hpp"

#include <numbers>

namespace ionskin::poroelasticity {
namespace {

double mobility(const Case& input) {
  const Water& water = input.water;
  return water.mobility > 0       ? water.mobility
         : water.permeability > 0 ? water.permeability / water.viscosity
                                  : water.consolidation_coefficient / consolidation_modulus(input);
}

} // namespace

double WaterProperties::consolidation_time(double thickness) const {
  return thickness * thickness / (std::numbers::pi * std::numbers::pi * consolidation_coefficient);
}

double WaterProperties::streaming_number() const {
  return valence * streaming_coefficient * drained_modulus / (dilution * thermal_voltage);
}

WaterProperties derive_water_properties(const Case& input) {
  using namespace constants;
  const Material& core = input.skin.layers[input.skin.core_index()].material;
  WaterProperties water;
  water.streaming_coefficient =
      input.water.drag_number * molar_volume_of_water / (input.electrochemistry.valence * faraday);
  water.drained_modulus = swelling_modulus(input);
  water.storage_modulus = storage_modulus(input);
  water.mobility = mobility(input);
  water.consolidation_coefficient =
      water.mobility * consolidation_modulus(input, water.drained_modulus);
  water.dilution =
      input.water.dilution == WaterDilution::mixture ? 1.0 : 1.0 / input.water.volume_fraction;
  water.skempton_coefficient = water.storage_modulus / bulk_modulus(core);
  water.thermal_voltage = gas_constant * input.electrochemistry.temperature / faraday;
  water.valence = input.electrochemistry.valence;
  water.held_share = input.strain.compression == 0
                         ? 0.0
                         : water.storage_modulus / (water.drained_modulus + water.storage_modulus);
  return water;
}

} // namespace ionskin::poroelasticity
