// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/live/skin_data.hpp"
#include "ionskin/live/training/random_touches.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ionskin::live {

/// States of the live contact along random paths, which cost next to nothing beside those of the
/// full model: landings, rests, onsets of slip, reversals, changes of load, at every friction of
/// the range in turn.
/// @param data with its contact
/// @returns forces of the cells [sample][3 cells] [N]
std::vector<std::vector<double>> contact_samples(const SkinData& data, const TouchRange& range,
                                                 std::size_t count, std::uint64_t seed);

} // namespace ionskin::live
