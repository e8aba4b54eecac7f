// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/poroelasticity/pore_pressure.hpp"

#include <functional>
#include <vector>

namespace ionskin::verification {

/// Layer of water-filled core with unit thickness, unit mobility and unit consolidation
/// coefficient, in quadratic elements through its thickness; all its quantities are dimensionless.
struct Layer {
  std::size_t elements = 12;        ///< number of elements; 12 as in a run
  poroelasticity::WaterWalls walls; ///< conditions on the water at both walls
  double held_share = 0; ///< share of the mean pressure that returns as load under a held
                         ///< compression, docs/model.md (75)
  poroelasticity::Relaxation relaxation; ///< relaxation of the solid, docs/model.md (76)

  /// Pore pressure P at the nodes at `time` after a step of the undrained pressure p_u, which is
  /// held from then on.
  /// @param undrained p_u as a function of the height from 0 to 1
  std::vector<double> after_step(const std::function<double(double)>& undrained, double time) const;
  /// Integral over the thickness of a function that is given by its values at the nodes.
  double integral(const std::vector<double>& values) const;
};

/// Smaller observed order of convergence between the errors of layers of 6, 12 and 24 elements.
/// @param error error of a layer of so many elements
double order_in_elements(const std::function<double(std::size_t elements)>& error);

} // namespace ionskin::verification
