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

/// Everything of a case that does not depend on the position of the slider: the elastic skin, the
/// underside and compliance of the slider, the mesh and the contact cells that move with the
/// slider. Shared by all threads.
struct SkinModel {
  mesh::SkinMesh mesh;
  ContactCells cells;
  /// Mean height of the slider's underside over each cell, above its lowest point [m].
  std::vector<double> gap;
  finite_layers::ComplianceForm form; ///< matrix or products
  /// Compliance of a soft slider under forces on the cells, [3 cells, 3 cells], symmetric [m/N].
  /// Empty for a rigid slider, and where products replace matrices.
  Eigen::MatrixXd slider_compliance;
  finite_layers::LayeredSkin layers;
  /// Short waves of skin and slider, where products replace matrices; null elsewhere.
  std::shared_ptr<const finite_layers::CellConvolution> short_waves;
  /// Inverse compliance wave by wave, the preconditioner, where products replace matrices; null
  /// elsewhere.
  std::shared_ptr<const finite_layers::InverseWaves> inverse;
  MotionBox places;  ///< box in which the slider's centre is expected [m]
  bool stays_across; ///< true if the slider's y is the same throughout

  /// Builds the model.
  /// @param footprint rectangle in which the slider may touch
  /// @param places_of_centre box in which the slider's centre is expected [m]; the resolution of
  ///   the faces depends on how near it comes to them
  SkinModel(const Case& input, const mesh::Footprint& footprint, const MotionBox& places_of_centre,
            mesh::MeshedPart part = mesh::MeshedPart::half_if_symmetric, int threads = 1,
            finite_layers::SkinPurpose purpose = finite_layers::SkinPurpose::results);

private:
  SkinModel(const Case& input, const MotionBox& places_of_centre, mesh::SkinMesh mesh_of_case,
            int threads, finite_layers::SkinPurpose purpose);
  void prepare_products(const Slider& slider);
};

/// Evaluates the compliance between skin and slider, docs/model.md (8), (36), at successive
/// positions of the slider. Caches what positions with the same y share.
class ContactCompliance {
public:
  /// @param model must outlive this object
  explicit ContactCompliance(const SkinModel& model) : model_(&model) {}

  /// Evaluates the compliance as a matrix.
  /// @param place centre of the slider [m]
  /// @param result receives the matrix, [3 cells, 3 cells], symmetric [m/N]; resized
  void at(const std::array<double, 2>& place, Eigen::MatrixXd& result);
  /// Evaluates the compliance and puts it into a contact problem, as a matrix or as products,
  /// whichever the model has.
  /// @param place centre of the slider [m]
  void at(const std::array<double, 2>& place, ContactProblem& problem);

private:
  std::shared_ptr<const finite_layers::CellProduct> product(const std::array<double, 2>& place);

  const SkinModel* model_;
  double centre_y_ = 0; ///< [m]
  std::optional<finite_layers::LayeredSkin::Across> across_;
  std::shared_ptr<const finite_layers::CellConvolution> short_waves_;
};

} // namespace ionskin::mechanics
