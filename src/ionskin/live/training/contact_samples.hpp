// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/live/data/skin_data.hpp"
#include "ionskin/live/touches/random_touches.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ionskin::live {

/// Cell forces of the reduced-order contact along random paths with landings, rests, onsets of
/// slip, reversals and changes of load, at friction coefficients over the trained range in turn.
/// They serve as samples for the modes of the strain, and cost next to nothing beside states of the
/// full model.
/// @param data trained model, complete as far as the contact is concerned
/// @param range within which the paths stay
/// @param count number of samples
/// @returns forces of the cells [sample][3 cells] [N]
std::vector<std::vector<double>> contact_samples(const SkinData& data, const TouchRange& range,
                                                 std::size_t count, std::uint64_t seed);

} // namespace ionskin::live
