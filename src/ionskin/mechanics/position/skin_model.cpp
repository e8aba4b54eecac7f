// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/position/skin_model.hpp"

#include "ionskin/mechanics/slider/slider_compliance.hpp"
#include "ionskin/mechanics/slider/slider_shape.hpp"

#include <utility>

namespace ionskin::mechanics {

SkinModel::SkinModel(const Case& input, const mesh::Footprint& footprint, mesh::MeshedPart part)
    : SkinModel(input, mesh::SkinMesh(input, footprint, part)) {}

SkinModel::SkinModel(const Case& input, mesh::SkinMesh mesh_of_case)
    : ElasticSkin(input, mesh_of_case), mesh(std::move(mesh_of_case)),
      gap(mean_gap(input.slider, cells.lines_x, cells.lines_y, {false, false})),
      slider_compliance(mechanics::slider_compliance(input.slider, mesh, cells)) {}

} // namespace ionskin::mechanics
