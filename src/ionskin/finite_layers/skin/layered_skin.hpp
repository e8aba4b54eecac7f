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

/// Form in which the compliance of the contact cells is given: a matrix, or products by
/// `CellProduct`.
enum class ComplianceForm { matrix, products };

/// Skin under the contact cells of a slider: a box of uniform layers on a rigid base, with its ends
/// free of stress and its sides free or held by rollers. All operators that depend only on the skin
/// and the cells are made once; the compliance of the cells then follows for any position of the
/// slider. Thread-safe.
class LayeredSkin {
public:
  /// Makes the operators of the skin, or takes them from the last `LayerBox` if its key was the
  /// same.
  /// @param grid of the contact cells
  /// @param threads number of threads to use
  /// @param form of the compliance; `products` makes no matrix of short waves
  LayeredSkin(const Skin& skin, ContactGrid grid, const SkinResolution& resolution, int threads = 1,
              ComplianceForm form = ComplianceForm::matrix);

  const ContactGrid& grid() const { return grid_; }

  /// Skin with the slider at one position across the skin.
  class Across {
  public:
    /// Calculates the compliance of the cells: mean displacements per force on a cell, a symmetric
    /// matrix [3 cell + component, 3 cell + component] with the components normal (downwards), x, y
    /// [m/N].
    /// @param centre_x position of the slider's centre along x, from the skin's corner [m]
    Eigen::MatrixXd compliance(double centre_x) const;

  private:
    friend class LayeredSkin;
    const LayeredSkin* skin_ = nullptr;
    /// Compliance of the rows of cells for each mode along x, [3 row + component, 3 row +
    /// component] [m2/N].
    std::vector<Eigen::MatrixXd> rows_;
    FreeEnds::Rows ends_;
    /// Part of the compliance that does not depend on the position along x [m/N].
    Eigen::MatrixXd alike_;
  };
  /// Fixes the position of the slider across the skin.
  /// @param centre_y position of the slider's centre along y, from the skin's corner [m]
  /// @returns a view that must not outlive this skin
  Across across(double centre_y) const;

  /// Makes the operators for strains within the skin under forces on the cells.
  /// @param heights,column,components,across as the constructor of `SkinFields` takes them
  /// @param threads number of threads to use
  /// @returns an object that must not outlive this skin
  SkinFields fields(const std::vector<double>& heights, double column,
                    const ComponentChoice& components = all_components,
                    const std::optional<PlacesAcross>& across = std::nullopt,
                    int threads = 1) const;
  /// Layers, bottom to top.
  const std::vector<ElasticLayer>& layers() const { return box_->key.layers; }
  /// True if rollers hold the sides, which then carry forces across the skin.
  bool sides_on_rollers() const { return !box_->key.free_sides; }

  /// Short-wave share of the skin's compliance, for `CellConvolution`.
  const PlaneCompliance& short_waves() const { return box_->short_waves; }
  /// Mirror images of the cells in the sides, as far as short waves reach them; empty where the
  /// sides are free.
  /// @param centre_y position of the slider's centre along y, from the skin's corner [m]
  std::vector<RowImage> images_in_sides(double centre_y) const;
  /// Long-wave share of the compliance, for `CellProduct`, with the slider at one position.
  /// @param centre position of the slider's centre along x and y, from the skin's corner [m]
  LongWaves long_waves(const std::array<double, 2>& centre) const;
  /// Compliance of the top face as a function of the wave number, for `InverseWaves`.
  WavesOfBody waves() const;

  /// Distance from a force beyond which short waves are not felt [m].
  double reach() const { return box_->key.resolution.reach; }
  /// Calculates the mean displacements of the cells caused by forces on the cells of another
  /// slider, [column, row] [m]. Only long waves are counted, docs/model.md (54), (56), (57), so
  /// that the sliders must be farther apart than `reach`.
  /// @param other cells of the other slider; not a half grid
  /// @param other_centre,centre positions of both sliders' centres, from the skin's corner [m]
  /// @param forces on the cells of the other slider [N]
  CellFields moved_by(const ContactGrid& other, const std::array<double, 2>& other_centre,
                      const CellFields& forces, const std::array<double, 2>& centre) const;

private:
  double clearance_of_ends(const ContactGrid& grid, double centre_x) const;
  NearEnds near_ends(double clearance) const;
  Eigen::ArrayXXd near_sides(double centre_y) const;

  ContactGrid grid_;
  std::shared_ptr<const LayerBox> box_;
  /// Part of the compliance of the rows of cells that does not depend on the position across the
  /// skin, for each mode along x [m2/N]; empty for a half grid and with `products`.
  std::vector<Eigen::MatrixXd> alike_rows_;
  /// Part of the compliance that does not depend on the position: short waves between the cells,
  /// and long waves without mirror images [m/N]; empty with `products`.
  Eigen::MatrixXd alike_;
};

} // namespace ionskin::finite_layers
