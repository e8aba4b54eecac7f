// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/linear_algebra/cholesky.hpp"
#include "ionskin/mechanics/elasticity/elastic_law.hpp"
#include "ionskin/mechanics/elasticity/elastic_space.hpp"
#include "ionskin/mechanics/surface/contact_cells.hpp"
#include "ionskin/mesh/skin_mesh.hpp"

#include <memory>
#include <mutex>
#include <semaphore>
#include <vector>

namespace ionskin::mechanics {

/// The symbolic factorisation with the footprint last, and how many factors the memory holds.
struct SkinAnalysis {
  linear_algebra::SymbolicCholesky symbolic;
  std::ptrdiff_t factors_at_once;
  mutable std::counting_semaphore<> free_factors;

  explicit SkinAnalysis(linear_algebra::SymbolicCholesky symbolic_factor);
};

/// Everything of a case that does not depend on the slider's position: numbering, contact cells,
/// elastic laws, symbolic factorisation. Shared by all threads.
struct SkinModel {
  mesh::SkinMesh mesh;
  ElasticSpace space;
  std::vector<ElasticLaw> law_of_row; ///< per element row along z
  ContactCells cells;
  std::vector<double> gap; ///< of the slider's underside over the cells [m]

  /// @param footprint in which the slider may touch
  SkinModel(const Case& input, const mesh::Footprint& footprint,
            mesh::MeshedPart part = mesh::MeshedPart::half_if_symmetric);
  /// Made at the first call: positions that come from a cache need none.
  const SkinAnalysis& analysis() const;

private:
  mutable std::once_flag analysed_;
  mutable std::unique_ptr<const SkinAnalysis> analysis_;
};

} // namespace ionskin::mechanics
