// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/position/elastic_skin.hpp"

#include "ionskin/mechanics/position/memory_estimate.hpp"
#include "ionskin/mechanics/position/position_input.hpp"

#include <algorithm>
#include <utility>

namespace ionskin::mechanics {
namespace {

std::vector<ElasticLaw> laws_of_rows(const Skin& skin, const mesh::SkinMesh& mesh) {
  std::vector<ElasticLaw> law_of_row;
  for (const std::size_t layer : mesh.layer_of_row()) {
    law_of_row.push_back(isotropic_elasticity(skin.layers[layer].material));
  }
  return law_of_row;
}

/// Factors that are held at the same time, within the memory meant for them.
std::ptrdiff_t factors_within_memory(const linear_algebra::SymbolicCholesky& symbolic) {
  constexpr double with_zeros = 1.1; // kept in the panels of the factor
  const double per_factor = 8 * with_zeros * symbolic.factor_entries();
  return std::max(std::ptrdiff_t{1}, static_cast<std::ptrdiff_t>(memory_for_factors / per_factor));
}

} // namespace

SkinAnalysis::SkinAnalysis(linear_algebra::SymbolicCholesky symbolic_factor)
    : symbolic(std::move(symbolic_factor)), factors_at_once(factors_within_memory(symbolic)),
      free_factors(factors_at_once) {}

ElasticSkin::ElasticSkin(const Case& input, const mesh::SkinMesh& mesh)
    : fixed(skin_boundary(input.skin, mesh.half_model())),
      space(mesh.lines(input.slider.start), fixed), law_of_row(laws_of_rows(input.skin, mesh)),
      layer_of_row(mesh.layer_of_row()), core_z(mesh.core_z()), cells(contact_cells(mesh, space)) {}

ElasticSkin::ElasticSkin(const PositionInput& input)
    : fixed(input.fixed), space(input.lines, fixed), law_of_row(input.law_of_row),
      layer_of_row(input.layer_of_row), core_z(input.core_z), cells(input.cells) {}

const SkinAnalysis& ElasticSkin::analysis() const {
  std::call_once(analysed_, [this] {
    analysis_ = std::make_unique<const SkinAnalysis>(linear_algebra::SymbolicCholesky(
        space.pattern(), space.elimination_order(cells.nodes), cells.unit_load.rows));
  });
  return *analysis_;
}

} // namespace ionskin::mechanics
