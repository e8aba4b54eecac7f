// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/coarser_solutions.hpp"

#include "ionskin/mesh/mesh_resolution.hpp"

#include <cstddef>

namespace ionskin::mechanics {

Case coarser_case(const Case& input, const std::string& coarser) {
  Case result = input;
  result.numerics.mesh_refinement *= 0.5;
  if (coarser == coarser_solutions::path) {
    result.numerics.time_refinement *= 0.5;
  } else if (coarser == coarser_solutions::thickness) {
    const std::size_t coarse = mesh::core_elements(result.numerics);
    while (mesh::core_elements(result.numerics) < 2 * coarse) {
      result.numerics.thickness_refinement *= 2;
    }
  }
  return result;
}

bool needs_coarser_thickness(const Case& input) {
  const Case coarser = coarser_case(input, coarser_solutions::mesh);
  return mesh::core_elements(input.numerics) == mesh::core_elements(coarser.numerics);
}

} // namespace ionskin::mechanics
