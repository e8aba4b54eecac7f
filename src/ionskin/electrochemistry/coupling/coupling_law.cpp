// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/coupling/coupling_law.hpp"

#include "ionskin/base/constants.hpp"
#include "ionskin/base/error.hpp"
#include "ionskin/electrochemistry/coupling/column_neutral.hpp"
#include "ionskin/electrochemistry/coupling/fixed_charge.hpp"
#include "ionskin/electrochemistry/coupling/pair_generation.hpp"
#include "ionskin/electrochemistry/coupling/volume_neutral.hpp"
#include "ionskin/history/core_history.hpp"
#include "ionskin/poroelasticity/water_properties.hpp"

#include <algorithm>
#include <array>

namespace ionskin::electrochemistry {
namespace {

/// A law that looks at one place at a time and needs no grid.
template <void (*law)(double, std::span<const double>, std::span<double>)>
void local(double coefficient, const ScaledGrid&, std::span<const double> shear,
           std::span<double> ratio) {
  law(coefficient, shear, ratio);
}

constexpr std::array laws{
    CouplingLaw{
        .name = "fixed-charge", .apply = local<apply_fixed_charge>, .makes_net_charge = true},
    CouplingLaw{.name = "volume-neutral", .apply = apply_volume_neutral},
    CouplingLaw{.name = "column-neutral", .apply = apply_column_neutral},
    CouplingLaw{
        .name = "pair-generation", .apply = local<apply_pair_generation>, .releases_ions = true},
    CouplingLaw{.name = "poroelastic", .apply = nullptr, .moves_water = true},
};

} // namespace

std::vector<std::string> CouplingLaw::channels() const {
  if (moves_water) {
    return {history::channel_name::undrained_pressure, history::channel_name::dilation};
  }
  return {history::channel_name::shear};
}

const history::HistoryChannel& CouplingLaw::channel(const history::CoreHistory& history) const {
  for (const std::string& candidate : channels()) {
    if (const history::HistoryChannel* found = history.find(candidate)) {
      return *found;
    }
  }
  throw InternalError("the history has no channel for the law " + std::string(name));
}

double charge_density_of_channel(const Case& input, const history::HistoryChannel& channel) {
  const double fixed = constants::faraday * input.electrochemistry.fixed_charge_concentration;
  if (!coupling_law(input.coupling.law).moves_water) {
    return fixed * input.coupling.coefficient;
  }
  const auto water = poroelasticity::derive_water_properties(input);
  return fixed * input.electrochemistry.valence * water.streaming_coefficient /
         water.thermal_voltage *
         (channel.name == history::channel_name::dilation ? water.storage_modulus : 1.0);
}

const CouplingLaw& coupling_law(const std::string& name) {
  const auto found = std::find_if(laws.begin(), laws.end(),
                                  [&](const CouplingLaw& law) { return law.name == name; });
  if (found == laws.end()) {
    throw InternalError("no coupling law is named " + name);
  }
  return *found;
}

} // namespace ionskin::electrochemistry
