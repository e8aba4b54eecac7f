// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/linear_algebra/sparse_matrix.hpp"
#include "ionskin/mechanics/surface/contact_cells.hpp"
#include "ionskin/mesh/skin_mesh.hpp"

namespace ionskin::mechanics {

/// How far the face of a soft slider gives under forces between it and the cells, docs/model.md
/// (36): what is to be added to the compliance of the skin. The slider is a half-space, or a layer
/// of its material on a rigid body; tractions are spread over the cells as on the skin. Empty for a
/// rigid slider. On a half model the mirrored forces act, too.
/// @return [3 cells, 3 cells], symmetric [m/N]
linear_algebra::DenseMatrix slider_compliance(const Slider& slider, const mesh::SkinMesh& mesh,
                                              const ContactCells& cells);

} // namespace ionskin::mechanics
