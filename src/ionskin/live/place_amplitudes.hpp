// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/live/skin_data.hpp"

#include <array>
#include <span>

namespace ionskin::live {

/// Amplitudes of the modes of a map at a place.
void place_amplitudes(const PlaceMap& map, const std::array<double, 2>& place,
                      std::span<double> amplitudes) noexcept;

/// Derivatives of the amplitudes by the place along x (0) or y (1) [1/m].
void place_slopes(const PlaceMap& map, const std::array<double, 2>& place, std::size_t direction,
                  std::span<double> slopes) noexcept;

} // namespace ionskin::live
