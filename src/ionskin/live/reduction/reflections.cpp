// SPDX-License-Identifier: Apache-2.0
#include "ionskin/live/reduction/reflections.hpp"

namespace ionskin::live {

Reflections::Reflections(bool along_x, bool along_y) {
  for (const bool y : {false, true}) {
    for (const bool x : {false, true}) {
      if ((along_x || !x) && (along_y || !y)) {
        elements_.push_back({x, y});
      }
    }
  }
}

double Reflections::sign(std::size_t parity, std::size_t g) const {
  const auto& odd = elements_[parity];
  const auto& reflected = elements_[g];
  return (odd[0] && reflected[0]) != (odd[1] && reflected[1]) ? -1 : 1;
}

std::size_t Reflections::image(std::size_t g, std::size_t index,
                               const std::array<std::size_t, 3>& size) const {
  std::size_t x = index % size[0], y = index / size[0] % size[1];
  const std::size_t z = index / size[0] / size[1];
  x = elements_[g][0] ? size[0] - 1 - x : x;
  y = elements_[g][1] ? size[1] - 1 - y : y;
  return (z * size[1] + y) * size[0] + x;
}

} // namespace ionskin::live
