// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/checks/check_metal.hpp"

#include "ionskin/base/text.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace ionskin {
namespace {

std::vector<Pointer> resistance_of(const CaseDocument& document, std::size_t layer) {
  return document.point_at(fmt::format("skin.layers[{}].sheet_resistance", layer));
}

/// Positions of all sheet resistances above 0.
std::vector<Pointer> resistances(const CaseDocument& document) {
  std::vector<Pointer> all;
  const std::vector<Layer>& layers = document.input.skin.layers;
  for (std::size_t i = 0; i < layers.size(); ++i)
    if (layers[i].sheet_resistance > 0)
      for (const Pointer& pointer : resistance_of(document, i))
        all.push_back(pointer);
  return all;
}

bool has_resistance(const Case& input) {
  return std::ranges::any_of(input.skin.layers,
                             [](const Layer& layer) { return layer.sheet_resistance > 0; });
}

} // namespace

void check_metal(const CaseDocument& document, Problems& problems) {
  const Case& input = document.input;
  for (std::size_t i = 0; i < input.skin.layers.size(); ++i) {
    const Layer& layer = input.skin.layers[i];
    if (layer.role == LayerRole::core && !resistance_of(document, i).empty())
      problems.add(fmt::format("the core \"{}\" has a sheet_resistance, which is that of an "
                               "electrode",
                               base::shown(layer.name)),
                   resistance_of(document, i),
                   "remove it: electrochemistry.diffusivity and "
                   "electrochemistry.fixed_charge_concentration make the core conduct");
  }
  if (!has_resistance(input) || input.readout.contact == ElectrodeContact::everywhere)
    return;
  if (!input.readout.taxels.empty())
    problems.add("the electrodes have a sheet_resistance and the leads of readout.contact, and "
                 "taxels have leads of their own",
                 resistances(document),
                 "remove readout.taxels, or sheet_resistance, or set readout.contact = "
                 "\"everywhere\"");
  if (input.electrochemistry.ion_model == IonModel::thin_layers)
    problems.add(
        "the ion model \"thin-layers\" supports only electrodes at one potential each, and they "
        "have a sheet_resistance here",
        resistances(document),
        "set electrochemistry.ion_model = \"dilute\", or readout.contact = "
        "\"everywhere\"");
}

std::vector<std::string> notes_on_metal(const CaseDocument& document) {
  const bool resists = has_resistance(document.input);
  const bool everywhere = document.input.readout.contact == ElectrodeContact::everywhere;
  const bool placed = !document.point_at("readout.contact").empty();
  if (placed && !resists && !everywhere)
    return {"readout.contact is given and not used: no electrode has a "
            "skin.layers[].sheet_resistance, so that each is at one potential."};
  if (resists && everywhere)
    return {"skin.layers[].sheet_resistance is given and not used: with readout.contact = "
            "\"everywhere\" leads hold the metal at one potential."};
  return {};
}

} // namespace ionskin
