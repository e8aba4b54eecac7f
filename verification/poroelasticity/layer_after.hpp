// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/poroelasticity/pore_pressure.hpp"

#include <functional>
#include <vector>

namespace ionskin::verification {

/// A layer of unit thickness, mobility and consolidation coefficient in quadratic elements.
struct Layer {
  std::size_t elements = 12; ///< as many as a run has
  poroelasticity::WaterWalls walls;
  double held_share = 0;                 ///< docs/model.md (75)
  poroelasticity::Relaxation relaxation; ///< docs/model.md (76)

  /// P at the nodes a time after a step of p_u, which is then held.
  std::vector<double> after_step(const std::function<double(double)>& undrained, double time) const;
  /// The integral of values at the nodes.
  double integral(const std::vector<double>& values) const;
};

/// Least observed order between errors of layers of 6, 12 and 24 elements.
double order_in_elements(const std::function<double(std::size_t elements)>& error);

} // namespace ionskin::verification
