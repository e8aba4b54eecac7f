// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/live/data/skin_data.hpp"
#include "ionskin/live/reduction/place_nodes.hpp"
#include "ionskin/mechanics/skin/skin_model.hpp"

#include <vector>

namespace ionskin::live {

/// Truncation of a `PlaceMap`: largest norm of a mode that is left out, over the norm of the mean.
inline constexpr double negligible_place_mode = 1e-5;

/// Decomposes vectors that are known at the nodes into their mean and modes.
/// @param nodes vectors [node, x fastest][size]
/// @param negligible norm of a mode over that of the mean, below which the mode is left out
PlaceMap place_map(const PlaceNodes& places, const std::vector<std::vector<float>>& nodes,
                   double negligible);

/// Computes the compliance of the contact cells at the nodes, and decomposes it [3 cells][3 cells]
/// [m/N].
PlaceMap reduce_compliance(const mechanics::SkinModel& model, const PlaceNodes& places);

} // namespace ionskin::live
