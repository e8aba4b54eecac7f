// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/mechanics/output/force_path.hpp"
#include "ionskin/mechanics/skin/skin_model.hpp"
#include "ionskin/mechanics/surface/contact_problem.hpp"

#include <array>
#include <vector>

namespace ionskin::mechanics {

/// Displacement of the cells of a slider at a place by the forces of others at a time [m]. Throws
/// SolverError where another presses nearer than short waves reach.
CellVector moved_by_others(const SkinModel& model, const std::vector<ForcePath>& others,
                           double time, const std::array<double, 2>& place);

} // namespace ionskin::mechanics
