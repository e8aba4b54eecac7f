// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/handover/strain_grid.hpp"
#include "ionskin/mesh/skin_mesh.hpp"

#include <vector>

namespace ionskin::handover {

/// Grid of the core that stays where it is while several sliders move over it: even cells wherever
/// one of them may touch, and beside those places cells that grow.
/// @param sliders one case each, of one skin
/// @param meshes one each; of halves those of y <= width / 2, which the grid then covers alone
CoreGrid fixed_core_grid(const std::vector<Case>& sliders,
                         const std::vector<const mesh::SkinMesh*>& meshes);

/// Widest of the even cells [m].
double fixed_cell_width(const Case& input);

} // namespace ionskin::handover
