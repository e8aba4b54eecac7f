// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/linear_algebra/cholesky.hpp"
#include "ionskin/mechanics/contact_cells.hpp"
#include "ionskin/mechanics/elastic_law.hpp"
#include "ionskin/mechanics/elastic_space.hpp"
#include "ionskin/mesh/skin_mesh.hpp"

#include <memory>
#include <vector>

namespace ionskin::mechanics {

/// Everything of a case that does not depend on the slider's position: numbering, symbolic
/// factorisation with the footprint last, contact cells, elastic laws. Shared by all threads.
struct SkinModel {
  mesh::SkinMesh mesh;
  ElasticSpace space;
  std::vector<ElasticLaw> law_of_row; ///< per element row along z
  ContactCells cells;
  std::vector<double> gap; ///< of the slider's underside over the cells [m]
  linear_algebra::SymbolicCholesky symbolic;

  explicit SkinModel(const Case& input,
                     mesh::MeshedPart part = mesh::MeshedPart::half_if_symmetric);
};

} // namespace ionskin::mechanics
