// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/live/skin_data.hpp"

#include <array>
#include <span>

namespace ionskin::live {

/// Amplitudes of the modes of a map at a place.
void place_amplitudes(const PlaceMap& map, const std::array<double, 2>& place,
                      std::span<double> amplitudes) noexcept;

} // namespace ionskin::live
