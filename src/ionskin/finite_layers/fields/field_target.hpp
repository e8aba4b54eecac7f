// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/finite_layers/fields/depth_table.hpp"
#include "ionskin/finite_layers/fields/face_fields.hpp"
#include "ionskin/finite_layers/fields/plane_waves.hpp"
#include "ionskin/finite_layers/fields/row_strains.hpp"

#include <vector>

namespace ionskin::finite_layers {

/// Levels in a skin.
struct FieldLevels {
  std::vector<DepthLevel> levels;
  std::vector<double> cutoffs; ///< wave number that is felt at each level [1/m]
};

/// A rectangle of the skin whose modes are summed [m].
struct PlaneBox {
  double x = 0, y = 0; ///< corner
  double length = 0, width = 0;
};

/// Strain at some levels, with the tables for them.
class FieldTarget {
public:
  FieldTarget(const FieldSkin& skin, FieldLevels levels, const ComponentChoice& components);

  const FieldLevels& levels() const { return levels_; }
  /// Zero at all places, of each kind of components
  /// [x, y + y's count * (component + components' count * level)].
  ByKind none(const FieldPlaces& places) const;
  /// A component at a level, [x, y]; empty where it was not chosen.
  Eigen::MatrixXd component(const ByKind& sums, const FieldPlaces& places, std::size_t component,
                            std::size_t level) const;
  /// Adds waves of a box to the strains of states.
  /// @param boxes of each state
  /// @param known null, or `row_strains` of the places along y that all states have
  /// @param sums as `none`
  void add_waves(const PlaneWaves& waves, const std::vector<WaveLoads>& loads,
                 const std::vector<PlaneBox>& boxes, const std::vector<FieldPlaces>& places,
                 const RowStrains* known, std::vector<ByKind>& sums) const;
  /// Strains at places along y by unit forces on rows of cells.
  /// @param rows of cells, [row, n]
  /// @param y places
  RowStrains row_strains(const PlaneWaves& waves, const PlaneBox& box, const ModeTransform& rows,
                         const std::vector<Interval>& y, int threads) const;
  const FaceFields& faces() const { return faces_; }

private:
  FieldLevels levels_;
  FieldComponents components_;
  DepthTable depth_;
  FaceFields faces_;
};

} // namespace ionskin::finite_layers
