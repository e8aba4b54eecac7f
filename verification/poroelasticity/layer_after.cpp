// SPDX-License-Identifier: Apache-2.0
#include "poroelasticity/layer_after.hpp"

#include "ionskin/poroelasticity/line_modes.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace ionskin::verification {

std::vector<double> Layer::after_step(const std::function<double(double)>& undrained,
                                      double time) const {
  poroelasticity::PorePressure water({1, 1}, {1.0, 1.0},
                                     poroelasticity::wall_clustered_nodes(1.0, elements), walls,
                                     1.0, held_share, relaxation);
  std::vector<double> load, pressure;
  for (const double z : water.nodes()) {
    load.push_back(undrained(z));
  }
  poroelasticity::PressureState begin, end;
  water.start(load, begin);
  water.step(begin, time, load, end);
  water.pressure(end, pressure);
  return pressure;
}

double Layer::integral(const std::vector<double>& values) const {
  const auto lengths =
      poroelasticity::node_lengths(poroelasticity::wall_clustered_nodes(1.0, elements));
  return std::inner_product(lengths.begin(), lengths.end(), values.begin(), 0.0);
}

double order_in_elements(const std::function<double(std::size_t elements)>& error) {
  const double coarse = std::abs(error(6)), middle = std::abs(error(12)),
               fine = std::abs(error(24));
  return std::min(std::log2(coarse / middle), std::log2(middle / fine));
}

} // namespace ionskin::verification
