// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/companions.hpp"

#include "ionskin/mesh/mesh_resolution.hpp"

#include <cstddef>

namespace ionskin::mechanics {

Case companion_case(const Case& input, const std::string& companion) {
  Case result = input;
  result.numerics.mesh_refinement *= 0.5;
  if (companion == companions::path) {
    result.numerics.time_refinement *= 0.5;
  } else if (companion == companions::thickness) {
    const std::size_t coarse = mesh::core_elements(result.numerics);
    while (mesh::core_elements(result.numerics) < 2 * coarse) {
      result.numerics.thickness_refinement *= 2;
    }
  }
  return result;
}

bool needs_thickness_companion(const Case& input) {
  const Case companion = companion_case(input, companions::mesh);
  return mesh::core_elements(input.numerics) == mesh::core_elements(companion.numerics);
}

} // namespace ionskin::mechanics
