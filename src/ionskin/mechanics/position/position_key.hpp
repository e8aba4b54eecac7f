// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/base/digest.hpp"
#include "ionskin/mechanics/position/elastic_skin.hpp"
#include "ionskin/mesh/skin_mesh.hpp"

namespace ionskin::mechanics {

/// Digest of all that a condensed position follows from, of the kernels of BLAS and of the version
/// of the numerical method: positions of the same key are the same to the last bit.
/// @param lines of the skin's mesh with the slider at its place [m]
base::Digest position_key(const ElasticSkin& skin, const mesh::MeshLines& lines);

} // namespace ionskin::mechanics
