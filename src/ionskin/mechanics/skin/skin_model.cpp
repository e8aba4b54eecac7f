// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/skin/skin_model.hpp"

#include "ionskin/mechanics/skin/skin_reach.hpp"
#include "ionskin/mechanics/slider/slider_compliance.hpp"
#include "ionskin/mechanics/slider/slider_shape.hpp"

#include <utility>

namespace ionskin::mechanics {
namespace {

finite_layers::ContactGrid contact_grid(const ContactCells& cells, bool half) {
  return {cells.lines_x, cells.lines_y, half};
}

finite_layers::SkinResolution resolution(const Skin& skin, const mesh::Footprint& footprint,
                                         const MotionBox& places,
                                         finite_layers::SkinPurpose purpose) {
  const auto [ends, sides] = clearance(skin, footprint, places);
  return finite_layers::skin_resolution(finite_layers::elastic_layers(skin), {ends, sides},
                                        purpose);
}

} // namespace

SkinModel::SkinModel(const Case& input, const mesh::Footprint& footprint,
                     const MotionBox& places_of_centre, mesh::MeshedPart part, int threads,
                     finite_layers::SkinPurpose purpose)
    : SkinModel(input, places_of_centre, mesh::SkinMesh(input, footprint, part), threads, purpose) {
}

SkinModel::SkinModel(const Case& input, const MotionBox& places_of_centre,
                     mesh::SkinMesh mesh_of_case, int threads, finite_layers::SkinPurpose purpose)
    : mesh(std::move(mesh_of_case)), cells(contact_cells(mesh)),
      gap(mean_gap(input.slider, cells.lines_x, cells.lines_y, {false, false})),
      slider_compliance(
          mechanics::slider_compliance(input.slider, contact_grid(cells, mesh.half_model()))),
      layers(input.skin, contact_grid(cells, mesh.half_model()),
             resolution(input.skin, mesh.footprint(), places_of_centre, purpose), threads),
      places(places_of_centre),
      // Off the middle a drive yields along y, too.
      stays_across(mesh.half_model() ||
                   (places.low[1] == places.high[1] && !input.motion.drive.given())) {}

void ContactCompliance::at(const std::array<double, 2>& place, Eigen::MatrixXd& result) {
  if (!across_ || centre_y_ != place[1]) {
    across_ = model_->layers.across(place[1]);
    centre_y_ = place[1];
  }
  result = across_->compliance(place[0]);
  if (model_->slider_compliance.size() > 0) {
    result += model_->slider_compliance;
  }
}

} // namespace ionskin::mechanics
