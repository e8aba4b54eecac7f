// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/case/slider_motion.hpp"
#include "ionskin/history/core_history.hpp"
#include "ionskin/mesh/skin_mesh.hpp"

#include <vector>

namespace ionskin::handover {

/// Grid of the core: edges of the cells along x and y, and mesh lines along z from the bottom of
/// the core [m]. x and y count from the slider's centre by `core_grid`, from the skin's corner by
/// `fixed_core_grid`. A half model has only the half of lower y.
struct CoreGrid {
  std::vector<double> x_edges, y_edges, z_lines;
};

/// Largest size of a cell outside the footprint [m].
double outer_cell_limit(const Skin& skin);

/// Makes the grid of the core. In a direction in which the slider moves, the cells move with it:
/// they are the mesh cells of the footprint, and outside it graded cells that cover the core from
/// every position of the slider. In another direction the cells are those of the mesh.
/// @param box all positions of the slider's centre [m]
CoreGrid core_grid(const Case& input, const mesh::SkinMesh& mesh, const MotionBox& box);

/// Makes the grid of the strain history for the whole core. It has twice as many z levels when the
/// coupling law of the case includes water transport.
/// @param core grid of the core, or of its half in a half model
history::StrainGrid strain_grid(const Case& input, const mesh::SkinMesh& mesh,
                                const CoreGrid& core);

/// Returns the mesh lines through the core, from its bottom [m].
/// @param lines of the mesh
std::vector<double> core_lines(const mesh::SkinMesh& mesh, const mesh::MeshLines& lines);

} // namespace ionskin::handover
