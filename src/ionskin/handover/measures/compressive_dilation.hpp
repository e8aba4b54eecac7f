// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

namespace ionskin::handover {

/// Channel `dilation`: -tr e at each point, positive where the core is compressed, which raises the
/// pressure of its water [1].
/// @param strain xx, yy, zz, yz, xz, xy, each [points] [1]
std::vector<double> compressive_dilation(const std::array<std::vector<double>, 6>& strain);

} // namespace ionskin::handover
