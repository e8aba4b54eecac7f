// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/finite_layers/faces/free_ends.hpp"
#include "ionskin/finite_layers/fields/skin_fields.hpp"
#include "ionskin/finite_layers/plane/inverse_waves.hpp"
#include "ionskin/finite_layers/plane/plane_compliance.hpp"
#include "ionskin/finite_layers/skin/layer_box.hpp"
#include "ionskin/finite_layers/skin/long_waves.hpp"

#include <Eigen/Core>

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace ionskin::finite_layers {

/// The compliance of the cells as a matrix, or as `CellProduct`.
enum class ComplianceForm { matrix, products };

/// A skin under the cells of a slider: a box of even layers on a rigid base, its ends free of
/// stress, its sides free or held by rollers. What depends on the skin and the cells alone is made
/// once; the compliance of the cells follows for any place of the slider. Thread-safe.
class LayeredSkin {
public:
  /// @param threads that compute the parts that no skin before has computed
  /// @param form in which the compliance of the cells is asked for
  LayeredSkin(const Skin& skin, ContactGrid grid, const SkinResolution& resolution, int threads = 1,
              ComplianceForm form = ComplianceForm::matrix);

  const ContactGrid& grid() const { return grid_; }

  /// The skin with the slider at one place across it.
  class Across {
  public:
    /// Mean displacements of the cells over the forces on them, [3 cell + component]: normal
    /// (downwards), x, y, symmetric [m/N].
    /// @param centre_x of the slider [m]
    Eigen::MatrixXd compliance(double centre_x) const;

  private:
    friend class LayeredSkin;
    const LayeredSkin* skin_ = nullptr;
    std::vector<Eigen::MatrixXd> rows_; ///< of each mode along the skin
    FreeEnds::Rows ends_;
    Eigen::MatrixXd alike_; ///< the part that does not depend on the place along the skin [m/N]
  };
  /// The skin with the slider's centre at a place across it.
  /// @param centre_y of the slider [m]; the skin outlives the result
  Across across(double centre_y) const;

  /// Strains within the skin, at some heights, under forces on the cells.
  /// @param heights,column,components,across as of SkinFields; the skin outlives the result
  SkinFields fields(const std::vector<double>& heights, double column,
                    const ComponentChoice& components = all_components,
                    const std::optional<PlacesAcross>& across = std::nullopt,
                    int threads = 1) const;
  const std::vector<ElasticLayer>& layers() const { return box_->key.layers; }
  /// True if rollers hold the sides, which then carry forces across the skin.
  bool sides_on_rollers() const { return !box_->key.free_sides; }

  /// Parts of the skin that `CellProduct` takes: its short waves and their images in sides on
  /// rollers, which depend on the place across it; its long waves with the slider at a place [m];
  /// and its compliance over the wave number.
  const PlaneCompliance& short_waves() const { return box_->short_waves; }
  std::vector<RowImage> images_in_sides(double centre_y) const;
  LongWaves long_waves(const std::array<double, 2>& centre) const;
  WavesOfBody waves() const;

  /// Distance beyond which short waves do not reach [m].
  double reach() const { return box_->key.resolution.reach; }
  /// Displacement of the cells with the slider at a place by forces on those of another slider,
  /// which lies farther away than `reach`, docs/model.md (54), (56), (57) [m].
  /// @param other its cells, none of them mirrored
  CellFields moved_by(const ContactGrid& other, const std::array<double, 2>& other_centre,
                      const CellFields& forces, const std::array<double, 2>& centre) const;

private:
  double clearance_of_ends(const ContactGrid& grid, double centre_x) const;
  NearEnds near_ends(double clearance) const;

  ContactGrid grid_;
  std::shared_ptr<const LayerBox> box_;
  Eigen::MatrixXd short_compliance_; ///< of the cells [m/N]
};

} // namespace ionskin::finite_layers
