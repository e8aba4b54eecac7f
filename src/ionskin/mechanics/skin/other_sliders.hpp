// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/mechanics/output/force_path.hpp"
#include "ionskin/mechanics/skin/skin_model.hpp"
#include "ionskin/mechanics/surface/contact_problem.hpp"

#include <array>
#include <vector>

namespace ionskin::mechanics {

/// Displacement of the cells of a slider by the forces of other sliders, [3 cells] [m].
/// @param others force paths of the other sliders
/// @param time since the begin of the cycle [s]
/// @param place centre of the slider whose cells are displaced [m]
/// Throws SolverError where another slider presses nearer than short waves in the skin reach.
CellVector moved_by_others(const SkinModel& model, const std::vector<ForcePath>& others,
                           double time, const std::array<double, 2>& place);

} // namespace ionskin::mechanics
