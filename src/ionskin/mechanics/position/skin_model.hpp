// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/mechanics/position/elastic_skin.hpp"
#include "ionskin/mesh/skin_mesh.hpp"

#include <vector>

namespace ionskin::mechanics {

/// Everything of a case that does not depend on the slider's position: the elastic skin, the mesh
/// whose lines follow the slider, and the slider with its underside. Shared by all threads.
struct SkinModel : ElasticSkin {
  mesh::SkinMesh mesh;
  std::vector<double> gap; ///< of the slider's underside over the cells [m]
  /// Of a soft slider against forces on the cells, [3 cells, 3 cells]; empty of a rigid one [m/N].
  linear_algebra::DenseMatrix slider_compliance;

  /// @param footprint in which the slider may touch
  SkinModel(const Case& input, const mesh::Footprint& footprint,
            mesh::MeshedPart part = mesh::MeshedPart::half_if_symmetric);

private:
  SkinModel(const Case& input, mesh::SkinMesh mesh_of_case);
};

} // namespace ionskin::mechanics
