// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/mesh/footprint.hpp"

#include <optional>

namespace ionskin::planning {

/// Pressure and shear under the slider before they are solved for.
struct ContactEstimate {
  double pressure = 0; ///< mean under a flat slider, largest under a round one, from above [Pa]
  double shear = 0;    ///< of the core below the sliding slider, from above [1]
  /// Shear that the core surely reaches [1]; 0 where the estimate cannot tell.
  double least_shear = 0;
  double area = 0; ///< of the contact [m2]
};

/// Estimate of the contact. From above, layers cannot move sideways: docs/model.md tells what the
/// model itself does. From below, they are squeezed out between bonded faces, and the shear is that
/// of a slide, no longer than the case's own, under a rigid flat slider and Coulomb's friction.
/// @param found the contact where a coarse solution has found it
ContactEstimate estimate_contact(const Case& input,
                                 const std::optional<mesh::Footprint>& found = std::nullopt);

} // namespace ionskin::planning
