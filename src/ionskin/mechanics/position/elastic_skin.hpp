// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/linear_algebra/cholesky.hpp"
#include "ionskin/mechanics/elasticity/elastic_law.hpp"
#include "ionskin/mechanics/elasticity/elastic_space.hpp"
#include "ionskin/mechanics/surface/contact_cells.hpp"
#include "ionskin/mesh/skin_mesh.hpp"

#include <array>
#include <cstddef>
#include <memory>
#include <mutex>
#include <semaphore>
#include <vector>

namespace ionskin::mechanics {

struct PositionInput;

/// The symbolic factorisation with the footprint last, and how many factors the memory holds.
struct SkinAnalysis {
  linear_algebra::SymbolicCholesky symbolic;
  std::ptrdiff_t factors_at_once;
  mutable std::counting_semaphore<> free_factors;

  explicit SkinAnalysis(linear_algebra::SymbolicCholesky symbolic_factor);
};

/// What the positions of a slider share: numbering, boundary conditions, elastic laws, contact
/// cells, symbolic factorisation. Independent of the places of the mesh lines. Thread-safe.
struct ElasticSkin {
  std::vector<FixedFace> fixed;
  ElasticSpace space;
  std::vector<ElasticLaw> law_of_row;    ///< per element row along z
  std::vector<std::size_t> layer_of_row; ///< index of the layer, per element row along z
  std::array<std::size_t, 2> core_z{};   ///< first and one-past-last element row of the core
  ContactCells cells;

  ElasticSkin(const Case& input, const mesh::SkinMesh& mesh);
  /// The same skin from what one of its positions needs.
  explicit ElasticSkin(const PositionInput& input);
  /// Made at the first call: positions that come from a cache need none.
  const SkinAnalysis& analysis() const;

private:
  mutable std::once_flag analysed_;
  mutable std::unique_ptr<const SkinAnalysis> analysis_;
};

} // namespace ionskin::mechanics
