// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/coupling/driving_channel.hpp"

#include "ionskin/base/constants.hpp"
#include "ionskin/base/error.hpp"
#include "ionskin/case/coupling.hpp"
#include "ionskin/poroelasticity/water_properties.hpp"

#include <algorithm>
#include <cmath>

namespace ionskin::electrochemistry {
namespace {

double fixed_charge_density(const Case& input) {
  return constants::faraday * input.electrochemistry.fixed_charge_concentration;
}

/// Charge per volume that a unit of pressure moves by streaming [C/m3/Pa].
double charge_density_of_pressure(const Case& input) {
  const auto water = poroelasticity::derive_water_properties(input);
  return fixed_charge_density(input) * input.electrochemistry.valence *
         water.streaming_coefficient / water.thermal_voltage;
}

} // namespace

std::vector<std::string> channels_for(const laws::CouplingLaw& law) {
  if (law.traits.moves_water) {
    return {history::channel_name::undrained_pressure, history::channel_name::dilation};
  }
  return {history::channel_name::shear};
}

const history::HistoryChannel& driving_channel(const std::string& law,
                                               const history::CoreHistory& history) {
  for (const std::string& candidate : channels_for(laws::coupling_law(law))) {
    if (const history::HistoryChannel* found = history.find(candidate)) {
      return *found;
    }
  }
  throw InternalError("the history has no channel for the law " + law);
}

double charge_density_of_channel(const Case& input, const history::HistoryChannel& channel) {
  if (!moves_water(input)) {
    return fixed_charge_density(input) * input.coupling.coefficient;
  }
  return charge_density_of_pressure(input) *
         (channel.name == history::channel_name::dilation
              ? poroelasticity::derive_water_properties(input).storage_modulus
              : 1.0);
}

double charge_moved_by_outside_water(const Case& input) {
  const double pressure =
      std::max(std::abs(input.water.bottom_pressure), std::abs(input.water.top_pressure));
  const double volume = input.skin.length * input.skin.width * input.skin.core_thickness();
  return pressure == 0 ? 0.0 : charge_density_of_pressure(input) * pressure * volume;
}

} // namespace ionskin::electrochemistry
