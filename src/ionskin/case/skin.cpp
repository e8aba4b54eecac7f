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

} // namespace ionskin
