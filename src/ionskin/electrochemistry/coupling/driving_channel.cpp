// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/coupling/driving_channel.hpp"

#include "ionskin/base/constants.hpp"
#include "ionskin/base/error.hpp"
#include "ionskin/case/coupling.hpp"
#include "ionskin/poroelasticity/water_properties.hpp"

namespace ionskin::electrochemistry {

std::vector<std::string> channels_for(const laws::CouplingLaw& law) {
  if (law.traits.moves_water) {
    return {history::channel_name::undrained_pressure, history::channel_name::dilation};
  }
  return {history::channel_name::shear};
}

const history::HistoryChannel& driving_channel(const Case& input,
                                               const history::CoreHistory& history) {
  for (const std::string& candidate : channels_for(laws::coupling_law(input.coupling.law))) {
    if (const history::HistoryChannel* found = history.find(candidate)) {
      return *found;
    }
  }
  throw InternalError("the history has no channel for the law " + input.coupling.law);
}

double charge_density_of_channel(const Case& input, const history::HistoryChannel& channel) {
  const double fixed = constants::faraday * input.electrochemistry.fixed_charge_concentration;
  if (!moves_water(input)) {
    return fixed * input.coupling.coefficient;
  }
  const auto water = poroelasticity::derive_water_properties(input);
  return fixed * input.electrochemistry.valence * water.streaming_coefficient /
         water.thermal_voltage *
         (channel.name == history::channel_name::dilation ? water.storage_modulus : 1.0);
}

} // namespace ionskin::electrochemistry
