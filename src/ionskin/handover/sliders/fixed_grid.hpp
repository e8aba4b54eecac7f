// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/handover/strain_grid.hpp"
#include "ionskin/mesh/skin_mesh.hpp"

#include <vector>

namespace ionskin::handover {

/// Makes the grid of the core for several sliders, which stays at rest in the skin: uniform cells
/// wherever a slider may touch, and graded cells elsewhere. x and y count from the skin's corner.
/// @param sliders one case per slider, all with the same skin
/// @param meshes one mesh per slider. If they are half models, the grid covers only y <= width / 2.
CoreGrid fixed_core_grid(const std::vector<Case>& sliders,
                         const std::vector<const mesh::SkinMesh*>& meshes);

/// Largest size of a uniform cell, except along a path so long that their number is limited [m].
double fixed_cell_width(const Case& input);

} // namespace ionskin::handover
