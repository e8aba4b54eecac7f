// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/case.hpp"

#include "ionskin/base/error.hpp"

namespace ionskin {

double Skin::thickness() const {
  double sum = 0;
  for (const Layer& layer : layers)
    sum += layer.thickness;
  return sum;
}

std::size_t Skin::core_index() const {
  for (std::size_t i = 0; i < layers.size(); ++i)
    if (layers[i].role == LayerRole::core)
      return i;
  throw InternalError("a skin without a core passed the checks of the case");
}

double Skin::core_bottom() const {
  double height = 0;
  for (std::size_t i = 0; i < core_index(); ++i)
    height += layers[i].thickness;
  return height;
}

double Skin::core_thickness() const {
  return layers[core_index()].thickness;
}

double Skin::core_volume() const {
  return length * width * core_thickness();
}

std::array<double, 2> Skin::sheet_resistances() const {
  std::array<double, 2> conductances{};
  for (std::size_t i = 0; i < layers.size(); ++i)
    if (layers[i].sheet_resistance > 0)
      conductances[i < core_index() ? 0 : 1] += 1 / layers[i].sheet_resistance;
  return {conductances[0] > 0 ? 1 / conductances[0] : 0,
          conductances[1] > 0 ? 1 / conductances[1] : 0};
}

bool Case::has_sheet_resistance() const {
  const std::array<double, 2> resistances = skin.sheet_resistances();
  return readout.contact != ElectrodeContact::everywhere &&
         (resistances[0] > 0 || resistances[1] > 0);
}

} // namespace ionskin
