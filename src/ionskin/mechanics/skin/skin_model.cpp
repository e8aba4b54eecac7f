// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/skin/skin_model.hpp"

#include "ionskin/mechanics/skin/compliance_form.hpp"
#include "ionskin/mechanics/skin/skin_reach.hpp"
#include "ionskin/mechanics/slider/slider_compliance.hpp"
#include "ionskin/mechanics/slider/slider_shape.hpp"

#include <utility>

namespace ionskin::mechanics {

using finite_layers::ComplianceForm;

namespace {

finite_layers::ContactGrid contact_grid(const ContactCells& cells, bool half) {
  return {cells.lines_x, cells.lines_y, half};
}

finite_layers::SkinResolution resolution(const Skin& skin, const mesh::Footprint& footprint,
                                         const MotionBox& places,
                                         finite_layers::SkinPurpose purpose) {
  const auto [ends, sides] = clearance(skin, footprint, places);
  return finite_layers::skin_resolution(skin, {ends, sides}, purpose);
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
      form(takes_products(input, cells) ? ComplianceForm::products : ComplianceForm::matrix),
      slider_compliance(
          form == ComplianceForm::matrix
              ? mechanics::slider_compliance(input.slider, contact_grid(cells, mesh.half_model()))
              : Eigen::MatrixXd()),
      layers(input.skin, contact_grid(cells, mesh.half_model()),
             resolution(input.skin, mesh.footprint(), places_of_centre, purpose), threads, form),
      places(places_of_centre),
      // Off the middle a drive yields along y, too.
      stays_across(mesh.half_model() ||
                   (places.low[1] == places.high[1] && !input.motion.drive.given())) {
  if (form == ComplianceForm::products) {
    prepare_products(input.slider);
  }
}

void SkinModel::prepare_products(const Slider& slider) {
  const finite_layers::ContactGrid& grid = layers.grid();
  const std::vector<finite_layers::RowImage> images = finite_layers::own_images(grid);
  auto convolution = std::make_shared<finite_layers::CellConvolution>(grid);
  convolution->include(layers.short_waves(), images);
  std::vector<finite_layers::WavesOfBody> bodies{layers.waves()};
  if (!slider.rigid()) {
    const SliderFace face = slider_face(slider);
    convolution->include(face.compliance, images, mixed_of_slider);
    bodies.push_back(face.waves);
  }
  short_waves = std::move(convolution);
  inverse = std::make_shared<const finite_layers::InverseWaves>(grid, bodies);
}

std::shared_ptr<const finite_layers::CellProduct>
ContactCompliance::product(const std::array<double, 2>& place) {
  if (!short_waves_ || centre_y_ != place[1]) {
    const auto images = model_->layers.images_in_sides(place[1]);
    short_waves_ = model_->short_waves;
    if (!images.empty()) {
      auto with_images = std::make_shared<finite_layers::CellConvolution>(*short_waves_);
      with_images->include(model_->layers.short_waves(), images);
      short_waves_ = std::move(with_images);
    }
    centre_y_ = place[1];
  }
  return std::make_shared<const finite_layers::CellProduct>(
      short_waves_, model_->layers.long_waves(place), model_->inverse);
}

void ContactCompliance::at(const std::array<double, 2>& place, ContactProblem& problem) {
  if (model_->form == ComplianceForm::products) {
    problem.product = product(place);
  } else {
    at(place, problem.compliance);
  }
}

void ContactCompliance::at(const std::array<double, 2>& place, Eigen::MatrixXd& result) {
  if (model_->form == ComplianceForm::products) { // column by column
    const auto of_place = product(place);
    const std::size_t size = 3 * model_->cells.count();
    result.resize(static_cast<Eigen::Index>(size), static_cast<Eigen::Index>(size));
    for (std::size_t column = 0; column < size; ++column) {
      CellVector unit(size, 0.0);
      unit[column] = 1;
      const CellVector moved = of_place->times(unit);
      result.col(static_cast<Eigen::Index>(column)) =
          Eigen::Map<const Eigen::VectorXd>(moved.data(), static_cast<Eigen::Index>(size));
    }
    return;
  }
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
