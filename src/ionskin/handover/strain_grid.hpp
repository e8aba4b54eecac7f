// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/case/slider_motion.hpp"
#include "ionskin/history/core_history.hpp"
#include "ionskin/mesh/skin_mesh.hpp"

#include <vector>

namespace ionskin::handover {

/// Cells of the core, of which a half model has those at y <= 0 alone: edges along x and y from the
/// slider's centre, mesh lines along z from the bottom of the core [m].
struct CoreGrid {
  std::vector<double> x_edges, y_edges, z_lines;
};

/// Longest cell beside the footprint [m].
double outer_cell_limit(const Skin& skin);

/// Grid of the core. In a direction in which the slider moves its cells ride with it: those of the
/// mesh under it, and beside them cells that grow and cover the core from every place.
/// @param box of the slider's places
CoreGrid core_grid(const Case& input, const mesh::SkinMesh& mesh, const MotionBox& box);

/// Grid of the history of the whole core; with twice the levels where the coupling law moves water.
history::StrainGrid strain_grid(const Case& input, const mesh::SkinMesh& mesh,
                                const CoreGrid& core);

/// Mesh lines through the core, from its bottom [m].
std::vector<double> core_lines(const mesh::SkinMesh& mesh, const mesh::MeshLines& lines);

} // namespace ionskin::handover
