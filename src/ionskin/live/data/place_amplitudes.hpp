// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/live/data/skin_data.hpp"

#include <array>
#include <span>

namespace ionskin::live {

/// Interpolates the mode amplitudes of a `PlaceMap` at a position of the slider.
/// @param place position of the slider's centre, within the nodes [m]
/// @param amplitudes receives the amplitudes [map.modes()]
void place_amplitudes(const PlaceMap& map, const std::array<double, 2>& place,
                      std::span<double> amplitudes) noexcept;

/// Computes the derivatives of the mode amplitudes of a `PlaceMap` by the position of the slider.
/// @param place position of the slider's centre, within the nodes [m]
/// @param direction 0: along x, 1: along y
/// @param slopes receives the derivatives [map.modes()] [1/m]
void place_slopes(const PlaceMap& map, const std::array<double, 2>& place, std::size_t direction,
                  std::span<double> slopes) noexcept;

} // namespace ionskin::live
