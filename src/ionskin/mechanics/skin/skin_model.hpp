// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/case/slider_motion.hpp"
#include "ionskin/finite_layers/skin/cell_product.hpp"
#include "ionskin/finite_layers/skin/layered_skin.hpp"
#include "ionskin/mechanics/surface/contact_cells.hpp"
#include "ionskin/mechanics/surface/contact_problem.hpp"
#include "ionskin/mesh/skin_mesh.hpp"

#include <Eigen/Core>

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace ionskin::mechanics {

/// Everything of a case that does not depend on the slider's place: the elastic skin, the slider
/// with its underside, and the lines that follow it. Shared by all threads.
struct SkinModel {
  mesh::SkinMesh mesh;
  ContactCells cells;
  std::vector<double> gap;            ///< of the slider's underside over the cells [m]
  finite_layers::ComplianceForm form; ///< of the compliance of the cells
  /// Compliance of a soft slider against forces on the cells, [3 cells, 3 cells]; empty of a rigid
  /// one, and where products stand for matrices [m/N].
  Eigen::MatrixXd slider_compliance;
  finite_layers::LayeredSkin layers;
  /// Short waves of skin and slider, where products stand for matrices.
  std::shared_ptr<const finite_layers::CellConvolution> short_waves;
  std::shared_ptr<const finite_layers::InverseWaves> inverse;
  MotionBox places;  ///< places at which the slider's centre is expected [m]
  bool stays_across; ///< true if its place across the skin is the same throughout

  /// @param footprint in which the slider may touch
  SkinModel(const Case& input, const mesh::Footprint& footprint, const MotionBox& places_of_centre,
            mesh::MeshedPart part = mesh::MeshedPart::half_if_symmetric, int threads = 1,
            finite_layers::SkinPurpose purpose = finite_layers::SkinPurpose::results);

private:
  SkinModel(const Case& input, const MotionBox& places_of_centre, mesh::SkinMesh mesh_of_case,
            int threads, finite_layers::SkinPurpose purpose);
  void prepare_products(const Slider& slider);
};

/// Compliance between skin and slider with the slider at one place after another,
/// docs/model.md (8), (36). What places with the same y share is kept from one to the next.
class ContactCompliance {
public:
  /// @param model outlives this
  explicit ContactCompliance(const SkinModel& model) : model_(&model) {}

  /// Compliance with the slider at a place, as a matrix.
  /// @param place of the slider's centre [m]
  /// @param result resized, [3 cells, 3 cells], symmetric [m/N]
  void at(const std::array<double, 2>& place, Eigen::MatrixXd& result);
  /// Puts the compliance at a place into a contact problem, in the form that the model has.
  void at(const std::array<double, 2>& place, ContactProblem& problem);

private:
  std::shared_ptr<const finite_layers::CellProduct> product(const std::array<double, 2>& place);

  const SkinModel* model_;
  double centre_y_ = 0; ///< [m]
  std::optional<finite_layers::LayeredSkin::Across> across_;
  std::shared_ptr<const finite_layers::CellConvolution> short_waves_;
};

} // namespace ionskin::mechanics
