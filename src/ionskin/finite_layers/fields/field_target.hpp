// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/finite_layers/fields/depth_table.hpp"
#include "ionskin/finite_layers/fields/face_motion.hpp"
#include "ionskin/finite_layers/fields/face_strain.hpp"
#include "ionskin/finite_layers/fields/plane_waves.hpp"
#include "ionskin/finite_layers/fields/row_strains.hpp"

#include <vector>

namespace ionskin::finite_layers {

/// Points or intervals along a skin; each of x meets each of y.
struct FieldPlaces {
  std::vector<Interval> x, y;
};

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

/// Strain at some levels, with what is tabulated for them.
class FieldTarget {
public:
  FieldTarget(const FieldSkin& skin, FieldLevels levels);

  const FieldLevels& levels() const { return levels_; }
  /// Zero at all places, [x, y + y's count * level].
  Strains none(const FieldPlaces& places) const;
  /// Adds waves of a box to the strains of states.
  /// @param boxes of each state
  /// @param known null, or `row_strains` of the places along y that all states have
  /// @param sums as `none`
  void add_waves(const PlaneWaves& waves, const std::vector<WaveLoads>& loads,
                 const std::vector<PlaneBox>& boxes, const std::vector<FieldPlaces>& places,
                 const RowStrains* known, std::vector<Strains>& sums) const;
  /// @param rows of cells, [row, n]
  /// @param y places
  RowStrains row_strains(const PlaneWaves& waves, const PlaneBox& box, const ModeTransform& rows,
                         const std::vector<Interval>& y, int threads) const;
  /// Adds what the motion of sides and ends strains.
  void add_faces(const std::vector<FaceMotion>& motions, const std::vector<FieldPlaces>& places,
                 std::vector<Strains>& sums) const;

private:
  FieldLevels levels_;
  DepthTable depth_;
  double length_, width_; ///< of the skin
  std::vector<FaceStrain> sides_, ends_;
};

} // namespace ionskin::finite_layers
