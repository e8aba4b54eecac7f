// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/live/reduction/place_nodes.hpp"
#include "ionskin/live/skin_data.hpp"
#include "ionskin/mechanics/skin/skin_model.hpp"

#include <vector>

namespace ionskin::live {

/// Truncation: largest norm of a mode that is left out of the part that changes with the place,
/// over the norm of the mean.
inline constexpr double negligible_place_mode = 1e-5;

/// Values at the nodes as a mean and the modes that are larger than a part of it.
PlaceMap place_map(const PlaceNodes& places, const std::vector<std::vector<float>>& nodes,
                   double negligible);

/// The compliance of the contact cells over the nodes.
PlaceMap reduce_compliance(const mechanics::SkinModel& model, const PlaceNodes& places);

} // namespace ionskin::live
