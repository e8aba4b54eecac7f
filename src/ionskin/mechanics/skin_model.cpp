// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/skin_model.hpp"

namespace ionskin::mechanics {
namespace {

/// More cells per element face resolve the edges better at the same factorisation, but the dense
/// contact problem grows with their fourth power; smaller elements at the edges are cheaper.
constexpr int cells_per_element_edge = 1;

std::vector<ElasticLaw> laws_of_rows(const Skin& skin, const mesh::SkinMesh& mesh) {
  std::vector<ElasticLaw> laws;
  for (const std::size_t layer : mesh.layer_of_row()) {
    laws.push_back(isotropic_elasticity(skin.layers[layer].material));
  }
  return laws;
}

linear_algebra::SymbolicCholesky analyse(const ElasticSpace& space, const ContactCells& cells) {
  return {space.pattern(), space.elimination_order(cells.nodes), cells.unit_load.rows};
}

} // namespace

SkinModel::SkinModel(const Case& input, mesh::MeshedPart part)
    : mesh(input, part),
      space(mesh.lines(input.slider.start), skin_boundary(input.skin, mesh.half_model())),
      law_of_row(laws_of_rows(input.skin, mesh)),
      cells(contact_cells(mesh, space, cells_per_element_edge)), gap(cells.count(), 0.0),
      symbolic(analyse(space, cells)) {}

} // namespace ionskin::mechanics
