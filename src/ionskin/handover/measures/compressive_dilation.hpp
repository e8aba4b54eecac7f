// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

namespace ionskin::handover {

/// Calculates the channel `dilation`, -tr e at each point [1]. It is positive where the core is
/// compressed, which raises the pressure of the water in the core.
/// @param strain components xx, yy, zz, yz, xz, xy, each [point] [1]
std::vector<double> compressive_dilation(const std::array<std::vector<double>, 6>& strain);

} // namespace ionskin::handover
