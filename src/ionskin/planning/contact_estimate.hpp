// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/mesh/footprint.hpp"

#include <optional>

namespace ionskin::planning {

/// Estimated pressure, area and shear of the contact between slider and skin, before Study 1 is
/// solved. Made by `estimate_contact`.
struct ContactEstimate {
  /// Upper estimate of the contact pressure: mean under a flat slider, largest under a round one
  /// [Pa].
  double pressure = 0;
  double shear = 0; ///< upper estimate of the shear of the core below the sliding slider [1]
  /// Lower bound of the shear that the core reaches [1]; 0 where none can be given.
  double least_shear = 0;
  double area = 0; ///< contact area [m2]
};

/// Estimates the contact from the layers in series, without solving it. The upper estimate takes
/// the layers as confined: they cannot move sideways. The lower bound lets bonded layers be
/// squeezed out sideways, and takes no more traction than Coulomb friction allows and the longest
/// slide of the case makes; it is given only for a rigid flat slider under Coulomb friction without
/// a drive. docs/model.md says what the model itself does.
/// @param found footprint of the contact from a coarse solution; empty to estimate it
ContactEstimate estimate_contact(const Case& input,
                                 const std::optional<mesh::Footprint>& found = std::nullopt);

} // namespace ionskin::planning
