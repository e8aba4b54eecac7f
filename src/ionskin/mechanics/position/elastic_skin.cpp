// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/position/elastic_skin.hpp"

#include "ionskin/mechanics/position/memory_estimate.hpp"

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

/// Across the longest way of the slider: all that lies in its way rides with it unchanged.
SkinCut cut_of(const mesh::SkinMesh& mesh) {
  const std::size_t axis = mesh.main_axis();
  return {axis, axis == 0 ? mesh.footprint_x() : mesh.footprint_y()};
}

/// Positions whose factors are held at the same time, within the memory meant for them. Room for a
/// part under the slider is counted for each, though they share it: a position takes about as much
/// beside its factors.
std::ptrdiff_t factors_within_memory(const SkinParts& parts) {
  constexpr double with_zeros = 1.1; // kept in the panels of the factor
  double entries = parts.inner.part->symbolic.factor_entries();
  for (const PlacedPart& placed : parts.outer) {
    entries += placed.part->symbolic.factor_entries();
  }
  return std::max(std::ptrdiff_t{1},
                  static_cast<std::ptrdiff_t>(memory_for_factors / (8 * with_zeros * entries)));
}

} // namespace

SkinAnalysis::SkinAnalysis(SkinParts skin_parts)
    : parts(std::move(skin_parts)), factors_at_once(factors_within_memory(parts)),
      free_factors(factors_at_once) {}

std::shared_ptr<SharedInner> SkinAnalysis::inner(const mesh::MeshLines& lines) const {
  const std::lock_guard lock(mutex_);
  if (!latest_.inner || latest_.lines != lines) {
    latest_ = {lines, std::make_shared<SharedInner>()};
  }
  return latest_.inner;
}

void SkinAnalysis::forget_inner() const {
  const std::lock_guard lock(mutex_);
  latest_ = {};
}

ElasticSkin::ElasticSkin(const Case& input, const mesh::SkinMesh& mesh)
    : fixed(skin_boundary(input.skin, mesh.half_model())),
      space(mesh.lines(input.slider.start), fixed, ElasticSpace::Structure::none),
      law_of_row(laws_of_rows(input.skin, mesh)), layer_of_row(mesh.layer_of_row()),
      core_z(mesh.core_z()), cells(contact_cells(mesh, space)), cut(cut_of(mesh)),
      any_lines_(mesh.lines(input.slider.start)) {}

const SkinAnalysis& ElasticSkin::analysis(int threads) const {
  std::call_once(analysed_, [&] {
    analysis_ = std::make_unique<const SkinAnalysis>(
        SkinParts(space, any_lines_, fixed, cells, cut, threads));
  });
  return *analysis_;
}

void ElasticSkin::forget_factors() const {
  if (analysis_) {
    analysis_->forget_inner();
  }
}

} // namespace ionskin::mechanics
