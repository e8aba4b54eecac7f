// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/finite_layers/fields/depth_table.hpp"
#include "ionskin/finite_layers/fields/face_fields.hpp"
#include "ionskin/finite_layers/fields/plane_waves.hpp"
#include "ionskin/finite_layers/fields/row_strains.hpp"

#include <vector>

namespace ionskin::finite_layers {

/// Levels in a skin at which strains are calculated.
struct FieldLevels {
  std::vector<DepthLevel> levels; ///< positions through the thickness
  std::vector<double> cutoffs;    ///< for each level, largest wave number that is felt there [1/m]
};

/// Rectangle of the skin over which modes are summed [m].
struct PlaneBox {
  double x = 0, y = 0; ///< corner with the smallest coordinates
  double length = 0, width = 0;
};

/// Calculates the strain of chosen components at given levels, and holds the tables for it.
class FieldTarget {
public:
  /// Tabulates the strain at the levels.
  /// @param components of the strain that are needed
  FieldTarget(const FieldSkin& skin, FieldLevels levels, const ComponentChoice& components);

  const FieldLevels& levels() const { return levels_; }
  /// Makes zero strain at all places, one matrix for each kind of components, [x, y + number of y *
  /// (component + number of components * level)].
  ByKind none(const FieldPlaces& places) const;
  /// Extracts one component at one level, [x, y]; empty if the component was not chosen.
  /// @param sums strain in the layout of `none`
  /// @param component 0 to 5 for xx, yy, zz, yz, xz, xy
  Eigen::MatrixXd component(const ByKind& sums, const FieldPlaces& places, std::size_t component,
                            std::size_t level) const;
  /// Adds the strain of the modes of a box, with one entry per state in each argument.
  /// @param loads forces on the cells, by the modes of the box
  /// @param boxes position of the box in the skin
  /// @param places at which strain is wanted
  /// @param known result of `row_strains` for the places along y that all states share; null
  /// without it
  /// @param sums to which the strain is added, in the layout of `none` [1]
  void add_waves(const PlaneWaves& waves, const std::vector<WaveLoads>& loads,
                 const std::vector<PlaneBox>& boxes, const std::vector<FieldPlaces>& places,
                 const RowStrains* known, std::vector<ByKind>& sums) const;
  /// Calculates the strain at places along y per unit force on rows of cells, which all states
  /// share whose slider keeps its position across the skin.
  /// @param rows means of the modes along y over the rows of cells, [row, n]
  /// @param y places, from the skin's corner [m]
  /// @param threads number of threads to use
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
